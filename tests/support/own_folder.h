/// A folder of a test's own, empty at its start and gone at its end.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>

namespace gnomon::test {

class OwnFolder : public testing::Test {
  protected:
    OwnFolder() {
        const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("gnomon-" + std::string(test.test_suite_name()) + "-" + test.name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~OwnFolder() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t files() const { return std::size_t(std::distance(std::filesystem::directory_iterator(folder_), {})); }

    std::filesystem::path folder_;
};

} // namespace gnomon::test
