/// Other particles for a time folder that is there or not.
#pragma once
#include "case/Cloud.hpp"

namespace sph
{

/// Writes a cloud into a time folder, at once (writeFolder). The particles that the folder had go, with what a run has stored of them: fields of theirs would
/// have another length. What else it holds stays. Throws CaseError where the disk is full or what stays cannot be copied; the folder is then as it was.
void replaceCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud, std::size_t n,
                  const FieldView& positions, const std::vector<FieldView>& fields, const WriteOptions&);

}
