"""All that cases/lab-to-outlet/laboratory/outlets prints is what README and page show: some two minutes of processor time."""

import subprocess
import sys

import draws
from draws import PAGE, STUDY, clod


class Draws(clod.Case):

    def test_pages_have_the_outlets_of_each_draw(self):
        done = subprocess.run([sys.executable, draws.SCRIPT, "--clod", clod.BINARY], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        slots, cones, curved = done.stdout.strip().split("\n\n")
        for table in (slots, cones):
            self.assertIn(table + "\n", STUDY)
        for slot, cone in zip(slots.splitlines()[2:], cones.splitlines()[2:]):
            cells = [cell.strip().split(";")[0] for cell in slot.split("|")[2:-1]]
            self.assertIn(f" | {' | '.join(cells)} | {cone.split('|')[-2].split(';')[0].strip()} |\n", PAGE)
        slot, cone = (part.split(" ", 1)[1] for part in curved.split(": ")[1].split(", "))
        self.assertIn(f"a slot of {slot.replace(' (', ' mm (', 1)} and a cone of {cone}", STUDY)


if __name__ == "__main__":
    clod.unittest.main()
