//! What an SVG file may ask for and this program cannot draw yet.

use std::{collections::BTreeSet, fmt};

use usvg::roxmltree::{Document, Node};

/// A kind of thing that is not drawn as the file asks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Missing {
    Opacity,
    Pattern,
    ClipPath,
    Mask,
    Filter,
    BlendMode,
    Text,
    Image,
    ForeignObject,
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Opacity => "opacity of groups (drawn opaque)",
            Self::Pattern => "patterns (left out)",
            Self::ClipPath => "clip paths other than upright rectangles (drawn unclipped)",
            Self::Mask => "masks (drawn unmasked)",
            Self::Filter => "filters (drawn unfiltered)",
            Self::BlendMode => "blend modes (drawn over what is below)",
            Self::Text => "text (left out)",
            Self::Image => "images (left out)",
            Self::ForeignObject => "foreign objects (left out)",
        })
    }
}

/// Each kind once.
pub(crate) type MissingKinds = BTreeSet<Missing>;

const SVG: &str = "http://www.w3.org/2000/svg";

/// Finds the elements that usvg, as it is built here, leaves out without a word: they have no trace in its tree.
pub(crate) fn elements_left_out(document: &Document<'_>) -> MissingKinds {
    let mut found = MissingKinds::new();
    visit(document.root_element(), &mut Vec::new(), &mut found);
    // A marker is named by a path, in an attribute, a style, or a style sheet, and so far in no other way.
    let markers = document.descendants().filter(|node| node.has_tag_name((SVG, "marker")));
    for marker in markers {
        let reference = marker.attribute("id").map(|id| format!("#{id}"));
        if reference.is_some_and(|reference| names(document.input_text(), &reference)) {
            visit_children(marker, &mut Vec::new(), &mut found);
        }
    }
    found
}

/// Whether a text has the reference, and not just the beginning of a longer one.
fn names(text: &str, reference: &str) -> bool {
    text.match_indices(reference).any(|(index, _)| {
        let after = text[index + reference.len()..].chars().next();
        after.is_none_or(|next| !(next.is_alphanumeric() || "-_.:".contains(next)))
    })
}

/// A file may refer in circles. It may also refer twice to what refers twice to something else, and so on: beyond this
/// many levels nothing is looked for.
const DEEPEST_REFERENCE: usize = 8;

/// Goes where a renderer goes: not into definitions that nothing uses, but through each `use` to what it names.
fn visit<'a>(node: Node<'a, 'a>, through: &mut Vec<Node<'a, 'a>>, found: &mut MissingKinds) {
    if node.tag_name().namespace() != Some(SVG) || node.attribute("display") == Some("none") {
        return;
    }
    match node.tag_name().name() {
        "text" => {
            let elsewhere = node.descendants().filter(|child| child.has_tag_name((SVG, "tref"))).filter_map(referred);
            if has_letters(node) || elsewhere.into_iter().any(has_letters) {
                found.insert(Missing::Text);
            }
        }
        "image" => {
            found.insert(Missing::Image);
        }
        "foreignObject" => {
            found.insert(Missing::ForeignObject);
        }
        "use" => {
            let known = |target: &Node<'a, 'a>| through.contains(target) || through.len() == DEEPEST_REFERENCE;
            if let Some(target) = referred(node).filter(|target| !known(target)) {
                through.push(target);
                if target.has_tag_name((SVG, "symbol")) {
                    visit_children(target, through, found);
                } else {
                    visit(target, through, found);
                }
                through.pop();
            }
        }
        "svg" | "g" | "a" | "switch" => visit_children(node, through, found),
        _ => {}
    }
}

fn has_letters(node: Node<'_, '_>) -> bool {
    let letters = node.descendants().filter_map(|child| child.is_text().then(|| child.text()).flatten());
    letters.into_iter().any(|text| !text.trim().is_empty())
}

fn visit_children<'a>(node: Node<'a, 'a>, through: &mut Vec<Node<'a, 'a>>, found: &mut MissingKinds) {
    node.children().filter(Node::is_element).for_each(|child| visit(child, through, found));
}

fn referred<'a>(node: Node<'a, 'a>) -> Option<Node<'a, 'a>> {
    const XLINK: &str = "http://www.w3.org/1999/xlink";
    let reference = node.attribute("href").or_else(|| node.attribute((XLINK, "href")))?;
    let id = reference.trim().strip_prefix('#')?;
    node.document().descendants().find(|candidate| candidate.attribute("id") == Some(id))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found_in(content: &str) -> Vec<Missing> {
        let namespaces = r#"xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink""#;
        let text = format!("<svg {namespaces}>{content}</svg>");
        let document = Document::parse(&text).expect("well-formed");
        elements_left_out(&document).into_iter().collect()
    }

    #[test]
    fn finds_what_a_viewer_would_show() {
        assert_eq!(found_in("<g><text>a</text><text>b</text></g>"), [Missing::Text]);
        assert_eq!(found_in("<text><tspan>a</tspan></text><image/>"), [Missing::Text, Missing::Image]);
        assert_eq!(found_in("<switch><foreignObject/></switch>"), [Missing::ForeignObject]);
    }

    #[test]
    fn passes_over_what_a_viewer_would_not_show() {
        assert_eq!(found_in("<title>a</title><rect/><text> \n </text>"), []);
        assert_eq!(found_in("<defs><text>a</text></defs><symbol><text>a</text></symbol>"), []);
        assert_eq!(found_in(r#"<g display="none"><text>a</text></g>"#), []);
        assert_eq!(found_in(r#"<text xmlns="https://example.org">a</text>"#), []);
    }

    #[test]
    fn looks_into_markers_and_for_text_that_stands_elsewhere() {
        let marker = r#"<marker id="m"><text>a</text><image/></marker>"#;
        let used = format!(r##"{marker}<path d="M0 0h9" style="marker-end:url(#m)"/>"##);
        assert_eq!(found_in(&used), [Missing::Text, Missing::Image]);
        let styled = format!("{marker}<style>path {{ marker: url('#m') }}</style><path d='M0 0h9'/>");
        assert_eq!(found_in(&styled), [Missing::Text, Missing::Image]);
        assert_eq!(found_in(&format!(r##"{marker}<path d="M0 0h9" marker-end="url(#mm)"/>"##)), []);
        let text = r#"<defs><text id="t">a</text><text id="e"> </text></defs>"#;
        assert_eq!(found_in(&format!(r##"{text}<text><tref xlink:href="#t"/></text>"##)), [Missing::Text]);
        assert_eq!(found_in(&format!(r##"{text}<text><tref xlink:href="#e"/></text>"##)), []);
    }

    #[test]
    fn follows_references_but_not_for_ever() {
        let symbol = r##"<symbol id="s"><text>a</text></symbol>"##;
        assert_eq!(found_in(&format!(r##"{symbol}<use href="#s"/>"##)), [Missing::Text]);
        assert_eq!(found_in(&format!(r##"{symbol}<use xlink:href="#s"/>"##)), [Missing::Text]);
        assert_eq!(found_in(r##"<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/><use href="#c"/></g>"##), []);
    }
}
