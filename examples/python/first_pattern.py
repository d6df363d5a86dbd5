"""From a curved patch to its pattern at true size."""

import planish

panel = planish.sample("panel", vertices=2000)  # or planish.read("panel.obj")

result = planish.flatten(panel, max_strain="2%")

print(f"{result.width:.0f} x {result.height:.0f} {result.unit}, strain at most {100 * result.strain_max:.2f} %")
result.svg("pattern.svg", allowance="10mm")
result.save("panel-pattern")  # all that the program writes, with the report
