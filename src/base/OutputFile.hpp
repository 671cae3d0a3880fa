/// A file being written through a large buffer. Every failure, above all a full disk, is thrown as CaseError naming file and reason.
#pragma once
#include "base/CaseError.hpp"
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

namespace sph
{

class OutputFile
{
public:
    /// Takes what would be written, in long pieces.
    using Taker = std::function<void(std::string_view)>;

private:
    static constexpr std::size_t capacity_ = 1 << 20;
    std::filesystem::path shown_;
    Taker taker_;
    std::unique_ptr<char[]> buffer_ = std::make_unique_for_overwrite<char[]>(capacity_);
    std::size_t used_ = 0;
    int descriptor_ = -1;

    [[noreturn]] void fail(int reason) const;
    void send(const char* data, std::size_t size);
    void writeLong(std::string_view);

public:
    /// Creates the file, or empties it.
    explicit OutputFile(const std::filesystem::path&);
    /// `shown`: its name in messages.
    OutputFile(const std::filesystem::path&, const std::filesystem::path& shown);
    /// No file: the taker gets the bytes.
    explicit OutputFile(Taker taker) : taker_(std::move(taker)) {}
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    /// Drops what has not been flushed: a file is whole only after `close`, which can fail where a destructor must not.
    ~OutputFile();

    /// Inlined: what is written are a few bytes of known length, millions of times.
    void write(std::string_view text)
    {
        if (text.size() > capacity_ - used_) return writeLong(text);
        std::memcpy(buffer_.get() + used_, text.data(), text.size());
        used_ += text.size();
    }
    void writeBytes(const void* data, std::size_t size) { write({static_cast<const char*>(data), size}); }
    /// `precision` significant digits; 0: the shortest text that reads back to the same number.
    void write(double, int precision);
    void write(std::int64_t);

    void flush();
    void close();
};

/// End of the name of a file or folder that is being written; it gets its own name when it is whole.
inline constexpr const char* partialSuffix = ".partial";

/// A whole file at once: written beside, and renamed when it is whole. A failure leaves what had the name before, and nothing else.
void writeFile(const std::filesystem::path&, std::string_view text);

/// Creates folders as std::filesystem::create_directories does, with the reason of a failure in a CaseError.
void createFolders(const std::filesystem::path&);

/// The text of a number: see OutputFile::write.
std::string shortestText(double);

}
