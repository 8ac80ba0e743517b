//! Where triangles that share edges leave cracks or overlap.

use super::{
    report::{Report, outcomes},
    triangles,
};
use crate::{
    measure::{
        Aim, Scene, Suite,
        subjects::{Mesh, OneByOne},
    },
    scenes, variants,
};

pub(crate) fn report(report: &mut Report) {
    report.heading("Shared edges: cracks and overlaps");
    report.say(
        "Fans and meshes, vertices on pixel centres and between: every pixel within belongs to one triangle. *Missing* is a \
         crack, *twice* an overlap, *extra* a pixel outside of the mesh. The methods that decide about shared edges:",
    );
    let meshes = || -> Vec<Mesh> {
        let mesh =
            |name: &'static str, count: usize| (0..count).map(move |index| Mesh(scenes::mesh(name, index).to_vec()));
        scenes::MESHES.into_iter().flat_map(|(name, count)| mesh(name, count)).collect()
    };
    let scene = vec![Scene { name: "meshes", shapes: meshes() }];
    let suite = Suite::new("shared edges", variants::triangle::SHARED, scene, |_, _| Aim::Fill);
    report.pixels("shared", "cracks and overlaps, by the methods that are worst", outcomes(&suite, "meshes"));
    report.say("All other methods of triangles, which know nothing of a neighbour:");
    let one_by_one = |family: &'static str| {
        let scene = vec![Scene { name: "meshes", shapes: meshes().into_iter().map(OneByOne).collect() }];
        let suite = Suite::new(family, triangles::list(family), scene, |_, _| Aim::Fill);
        outcomes(&suite, "meshes")
    };
    let outcomes = triangles::FAMILIES.into_iter().flat_map(one_by_one).collect();
    report.pixels("shared-others", "cracks and overlaps of the others, by those that are worst", outcomes);
}
