/// A disk of a test's own that is soon full, in memory; only root may make one.
#pragma once
#include "TestCase.hpp"
#include <sys/mount.h>

namespace sph::test
{

class SmallDisk
{
    TestCase place_{Files{}};
    bool mounted_;

public:
    /// Why a test that needs one is left out.
    static constexpr auto notPermitted = "a small disk is made by mounting a tmpfs, which this machine does not permit";

    /// `size` as mount has it, "128k".
    explicit SmallDisk(const std::string& size) : mounted_(::mount("tmpfs", folder().c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0) {}
    SmallDisk(const SmallDisk&) = delete;
    ~SmallDisk()
    {
        if (mounted_) ::umount2(folder().c_str(), MNT_DETACH);
    }
    bool mounted() const { return mounted_; }
    const std::filesystem::path& folder() const { return place_.folder(); }
};

}
