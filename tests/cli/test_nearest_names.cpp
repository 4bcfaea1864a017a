// Whatever name is mistyped, the one that was meant is told. Expected: each name with a slip of the hand in it.
#include <string>

#include "check.hpp"
#include "cli/scratch_folder.hpp"
#include "run_program.hpp"

using check::run_tiltrotor;

TEST(cli_bad_names_are_told_the_nearest) {
  const check::ScratchFolder folder;
  const auto file = [&](const char* name, const std::string& text) { return folder.write(name, text); };
  const struct {
    std::string arguments;
    const char* meant;
  } slips[] = {
      {"trimm", "trim"},
      {"help sensitivty", "sensitivity"},
      {"--hlep", "help"},
      {"--verson", "version"},
      {"trim --hepl", "--help"},
      {"trim --altitud 3", "--altitude"},
      {"completion bsh", "bash"},
      {"trim --format cvs", "csv"},
      {"trim --grid realtme", "realtime"},
      {"trim --preset refrence", "reference"},
      {"trim --option gird=realtime", "grid"},
      {"trim --option governor=idael", "ideal"},
      {"trim --units knotts", "knots"},
      {"trim --speed 40ktt", "kt"},
      {"trim --columns pich_deg", "pitch_deg"},
      {"trim --columns power_rigth", "power_right"},
      {"trim --hold power_kv=0 --free climb_deg", "power_kw"},
      {"trim --hold power_kw=0 --free clim_deg", "climb_deg"},
      {"trim --ball centered", "centred"},
      {"modes --show shape", "shapes"},
      {"modes --show shapes --normalise thta", "theta"},
      {"modes --reduce rigidd", "rigid"},
      {"linearize --control-set inceptor", "inceptors"},
      {"bode --from elevatr", "elevator"},
      {"bode --to thetta", "theta"},
      {"qualities --scas onn", "on"},
      {"sensitivity --of trm", "trim"},
      {"sensitivity --to fin_aera", "fin_area"},
      {"sensitivity --mast 90 --speed 100 --grid realtime --to mass --mode dutch_rol", "dutch_roll"},
      {"respond --method rk44", "rk4"},
      {"respond --input colective=1deg@0", "collective"},
      {"respond --input mst=30deg@1..5", "mast"},
      {"respond --input collective=1dge@0", "deg"},
      {"respond --input pedal=1in@1..3:doublett", "doublet"},
      {"derivative --states " + file("states.csv", "pich_deg\n0\n"), "pitch_deg"},
      {"respond --feedback " + file("law.csv", "input,thta\npedal,1\n"), "theta"},
      {"respond --feedback " + file("inputs.csv", "input,theta\npedall,1\n"), "pedal"},
      {"trim --config " + file("options", "sped = 40\n"), "--speed"},
      {"fly --script " + file("command", "0 hld speed 40\n1 end\n"), "hold"},
      {"fly --script " + file("loop", "0 hold sped 40\n1 end\n"), "speed"},
      {"fly --script " + file("word", "0 gear upp\n1 end\n"), "up"},
      {"fly --script " + file("unit", "0 hold speed 40ktt\n1 end\n"), "kt"},
  };
  for (const auto& slip : slips) {
    const check::ProgramResult result = run_tiltrotor(slip.arguments);
    CHECK_LT(0, result.exit_status);
    if (!CHECK(result.err.find(std::string("(did you mean ") + slip.meant + "?)") != std::string::npos))
      NOTE(slip.arguments << ": " << result.err);
  }
}
