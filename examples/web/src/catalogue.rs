//! What the page offers, as JSON.

use spanfill::methods::FAMILIES;

use crate::{
    drawing::{Choice, drawing, is_antialiased},
    subject::{KINDS, Subject},
};

/// The method that the page names by its places in `FAMILIES`.
pub fn choice(family: usize, method: usize, option: usize) -> Option<Choice> {
    let family = FAMILIES.get(family)?;
    let method = family.methods.get(method)?;
    Some(Choice { family: family.name, method: method.name, option: method.options.get(option)? })
}

/// Every method with every option, by its places in `FAMILIES`.
pub fn choices() -> impl Iterator<Item = ([usize; 3], Choice)> {
    FAMILIES.iter().enumerate().flat_map(|(family, of)| {
        of.methods.iter().enumerate().flat_map(move |(method, of)| {
            (0..of.options.len())
                .filter_map(move |option| Some(([family, method, option], choice(family, method, option)?)))
        })
    })
}

/// Kinds of subjects with their vertices, and methods with their sources; each option with the kinds that it draws.
pub fn json() -> String {
    let list = |items: Vec<String>| format!("[{}]", items.join(","));
    let kinds = KINDS.iter().map(|(name, points)| format!("{{\"name\":{name:?},\"points\":{points:?}}}")).collect();
    let subjects: Vec<Subject> = (0..KINDS.len()).filter_map(|kind| Subject::new(kind, &[])).collect();
    let option = |place: [usize; 3], name: &str| {
        let choice = choice(place[0], place[1], place[2])?;
        let draws = subjects.iter().enumerate().filter(|(_, subject)| drawing(subject, &choice).is_some());
        let draws: Vec<usize> = draws.map(|(kind, _)| kind).collect();
        Some(format!("{{\"name\":{name:?},\"draws\":{draws:?},\"antialiased\":{}}}", is_antialiased(&choice)))
    };
    let families = FAMILIES.iter().enumerate().map(|(family, of)| {
        let methods = of.methods.iter().enumerate().map(|(method, of)| {
            let options = of.options.iter().enumerate().filter_map(|(at, name)| option([family, method, at], name));
            let (name, source, options) = (of.name, of.source, list(options.collect()));
            format!("{{\"name\":{name:?},\"source\":{source:?},\"options\":{options}}}")
        });
        format!("{{\"name\":{:?},\"methods\":{}}}", of.name, list(methods.collect()))
    });
    format!("{{\"kinds\":{},\"families\":{}}}", list(kinds), list(families.collect()))
}
