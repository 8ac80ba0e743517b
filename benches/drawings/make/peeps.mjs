// Puts twelve people together from the parts of Open Peeps: peeps/00.svg to peeps/11.svg.
import fs from "node:fs";
import { createAvatar } from "@dicebear/core";
import * as openPeeps from "@dicebear/open-peeps";

fs.mkdirSync("peeps", { recursive: true });
for (let index = 0; index < 12; index++) {
    const options = { seed: `peep-${index}`, accessoriesProbability: 60, facialHairProbability: 40 };
    fs.writeFileSync(`peeps/${String(index).padStart(2, "0")}.svg`, createAvatar(openPeeps, options).toString());
}
