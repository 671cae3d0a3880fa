/// A table that a run has left behind, with its columns by name.
#pragma once
#include "dictionary/ExpressionProgram.hpp"
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sph
{

/// A table of a function object (`conservation.dat`: the last line of its head has the names, blanks or tabs between cells) or of
/// comma-separated values (the first line has the names). Cells are texts until a column is asked for.
class RunTable
{
    std::string file_;
    std::vector<std::string> names_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<int> lines_; ///< of each row in its file, from 1

    std::size_t column(const std::string& name) const;
    bool has(const std::string& name) const;

public:
    /// `file` relative to `folder`, as messages name it. Throws CaseError where it cannot be read.
    RunTable(const std::filesystem::path& folder, const std::string& file);
    /// Rows that were found elsewhere, as in a log.
    RunTable(std::string file, std::vector<std::string> names, std::vector<std::vector<std::string>> rows, std::vector<int> lines)
        : file_(std::move(file)), names_(std::move(names)), rows_(std::move(rows)), lines_(std::move(lines))
    {}

    const std::string& file() const { return file_; }
    const std::vector<std::string>& names() const { return names_; }
    std::size_t size() const { return rows_.size(); }
    std::vector<std::size_t> allRows() const;
    /// Those of the rows whose columns hold one of these words or numbers each. Throws CaseError naming the columns where one is not there.
    std::vector<std::size_t> select(const std::map<std::string, std::vector<std::string>>& wanted) const;
    const std::string& cell(std::size_t row, const std::string& name) const;

    /// A column as an expression asks for it, of some rows.
    struct Column
    {
        ExpressionProgram::Kind kind = ExpressionProgram::Kind::number;
        std::array<std::vector<double>, 3> value = {};
    };
    /// `name`; of a vector `(1 2 3)` a component by `name_x`; of a scene with one phase, whose columns go without it, `name` for `name_water`;
    /// of a column `stress.xx [Pa]` its name without the unit. Nothing where there is no such column; throws CaseError with file and
    /// line where a cell is no number. An empty cell, and `nan`, is NaN.
    std::optional<Column> find(const std::string& name, const std::vector<std::size_t>& rows) const;
};

/// The file, relative to `folder`, that `name` stands for in a run's folder: a path, also below postProcessing, or a function object, of which it is
/// the table of its last start time: "conservation", "bottom/p", "errors/0.5". Throws CaseError with what is there.
std::string tableFile(const std::filesystem::path& folder, const std::filesystem::path& run, const std::string& name);

}
