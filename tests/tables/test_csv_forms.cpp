// Tables in the forms of CSV that spreadsheets write: the same cells, or a fault of file and line.
// Expected: the cells of the plain form; RFC 4180.
#include <cstdio>
#include <fstream>

#include "check.hpp"
#include "tablegen/csv.hpp"
#include "tablegen/fault.hpp"
#include "temporary.hpp"

namespace {

class TableFile {
 public:
  explicit TableFile(const std::string& text) : path_(check::new_temporary_file()) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TableFile() { std::remove(path_.c_str()); }
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string fault_of(const std::string& text) {
  const TableFile file(text);
  try {
    tablegen::read_csv(file.path());
  } catch (const tablegen::Fault& fault) {
    return std::to_string(fault.line) + ": " + fault.message;
  }
  return "none";
}

}  // namespace

TEST(tablegen_reads_every_form_of_csv) {
  const std::string plain = "# source\nname,value\nspan,\"9,8\"\nchord,1\n";
  for (const std::string& text :
       {plain, "\xef\xbb\xbf" + plain,
        std::string("# source\r\n\"name\",\"value\"\r\n\r\nspan,\"9,8\"\r\nchord,1"),
        std::string("\xef\xbb\xbf# source\n name , value \nspan,\"9,8\" \n\nchord , 1\n")}) {
    const TableFile file(text);
    const tablegen::Csv csv = tablegen::read_csv(file.path());
    CHECK_EQ(csv.comments, std::string("# source\n"));
    CHECK(csv.header == std::vector<std::string>({"name", "value"}));
    if (!CHECK_EQ(csv.rows.size(), 2u)) continue;
    CHECK_EQ(csv.rows[0].cell[1], std::string("9,8"));
    CHECK_EQ(csv.rows[1].cell[1], std::string("1"));
  }
}

TEST(tablegen_refuses_other_forms_with_the_line) {
  CHECK_EQ(fault_of("a,b\n1,\"2\n"), std::string("2: a quotation mark is not closed on its line"));
  CHECK_EQ(fault_of("a,b\n1,\"2\"3\n"), std::string("2: text follows a closed quotation mark"));
  CHECK(fault_of("a,b\n1,2\"\n").find("2: a quotation mark stands inside a cell") == 0);
  CHECK_EQ(fault_of(std::string("a,b\n1,2\0\n", 9)), std::string("2: the line holds a NUL byte"));
  CHECK_EQ(fault_of("a,b\ncaf\xe9,2\n"), std::string("2: the text is not UTF-8"));
  CHECK_EQ(fault_of("\xff\xfe"
                    "a,b\n1,2\n"),
           std::string("1: the file is UTF-16; save it as UTF-8"));
  CHECK_EQ(fault_of("a,b,\n1,2,\n"), std::string("1: column without a name"));
  CHECK_EQ(fault_of("a,b\n1,2,\n"), std::string("2: 3 cells, the header has 2"));
}
