//! A model in bytes.

use core::fmt;

use embedded_graphics_core::pixelcolor::{Rgb565, raw::RawU16};

use crate::splat::{NORMAL_CODES, SPHERE_CODES, Sphere};

/// What is wrong with a model's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BrokenModel {
    /// They do not begin with `SPL1` and a root.
    NoHeader,
    /// They end before what an offset leads to.
    Ends {
        /// Where it leads to.
        offset: usize,
    },
    /// An offset leads backwards.
    Backwards {
        /// Where it leads to.
        offset: usize,
    },
    /// A code that no sphere or normal has.
    Code {
        /// Where the node is.
        offset: usize,
    },
    /// More than 24 levels.
    TooDeep,
    /// Groups lead to more nodes than there are.
    TooManyNodes,
    /// Groups lead to fewer nodes than there are.
    TooFewNodes {
        /// How many are not met.
        missing: u32,
    },
}

impl fmt::Display for BrokenModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoHeader => f.write_str("not a model of splats"),
            Self::Ends { offset } => write!(f, "the model ends before its offset {offset}"),
            Self::Backwards { offset } => write!(f, "an offset leads backwards, to {offset}"),
            Self::Code { offset } => write!(f, "the node at {offset} has a code without a meaning"),
            Self::TooDeep => f.write_str("the model has more than 24 levels"),
            Self::TooManyNodes => f.write_str("the model's groups lead to more nodes than it has"),
            Self::TooFewNodes { missing } => write!(f, "the model's groups do not lead to {missing} of its nodes"),
        }
    }
}

impl core::error::Error for BrokenModel {}

/// A node's bytes, taken apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Node {
    /// Where it is and how large, within its parent.
    pub sphere: u16,
    /// How many children it has: 0, 2, 3 or 4.
    pub children: u8,
    /// Whether any of them has children.
    pub grandchildren: bool,
    /// Its direction.
    pub normal: u16,
    /// How far the directions below it are spread: an index into [`CONE_SINES`](crate::splat::CONE_SINES).
    pub cone: u8,
    /// Its colour.
    pub colour: Rgb565,
}

/// Bytes of a node, of an offset.
const NODE: usize = 6;
const OFFSET: usize = 4;

impl Node {
    /// From its bytes; whether its codes mean anything is not looked at.
    #[inline]
    pub fn from_bytes([a, b, c, d, e, f]: [u8; 6]) -> Self {
        let (low, middle) = (u16::from_le_bytes([a, b]), u16::from_le_bytes([c, d]));
        Self {
            sphere: low & 0x1fff,
            children: match (low >> 13) & 3 {
                0 => 0,
                1 => 2,
                2 => 3,
                _ => 4,
            },
            grandchildren: low >> 15 != 0,
            normal: middle & 0x3fff,
            cone: middle.to_le_bytes()[1] >> 6,
            colour: RawU16::new(u16::from_le_bytes([e, f])).into(),
        }
    }

    /// To its bytes.
    pub fn to_bytes(&self) -> [u8; 6] {
        use embedded_graphics_core::pixelcolor::IntoStorage;
        let children = match self.children {
            0 | 1 => 0,
            2 => 1,
            3 => 2,
            _ => 3,
        };
        let low = (self.sphere & 0x1fff) | children << 13 | u16::from(self.grandchildren) << 15;
        let middle = (self.normal & 0x3fff) | u16::from(self.cone & 3) << 14;
        let ([a, b], [c, d]) = (low.to_le_bytes(), middle.to_le_bytes());
        let [e, f] = self.colour.into_storage().to_le_bytes();
        [a, b, c, d, e, f]
    }

    /// The bytes of its children's group.
    #[inline]
    pub(super) fn group_bytes(&self) -> usize {
        usize::from(self.children) * NODE + if self.grandchildren { OFFSET } else { 0 }
    }
}

/// A model: a view of its bytes.
#[derive(Debug, Clone, Copy)]
pub struct Model<'a> {
    bytes: &'a [u8],
    nodes: u32,
    pub(super) root: Sphere,
    pub(super) root_node: Node,
    pub(super) root_group: usize,
}

/// The largest coordinate of a root's centre or its radius: what lies below it fits `i32` with two bits to spare.
const REACH: i32 = 1 << 26;

/// Bytes of the header.
const HEADER: usize = 34;

impl<'a> Model<'a> {
    /// A model from its bytes. Only the header is looked at: what is broken further on is found when it is drawn, or by
    /// [`check`](Self::check).
    ///
    /// # Errors
    ///
    /// [`BrokenModel`].
    pub fn new(bytes: &'a [u8]) -> Result<Self, BrokenModel> {
        let header = bytes.get(..HEADER).ok_or(BrokenModel::NoHeader)?;
        let word = |at: usize| {
            let word = header.get(at..).and_then(<[u8]>::first_chunk::<4>).ok_or(BrokenModel::NoHeader)?;
            Ok(u32::from_le_bytes(*word))
        };
        if header.first_chunk() != Some(b"SPL1") {
            return Err(BrokenModel::NoHeader);
        }
        let (nodes, x, y, z) = (word(4)?, word(8)?, word(12)?, word(16)?);
        let centre = [x, y, z].map(u32::cast_signed);
        let radius = word(20)?.cast_signed();
        let reachable = centre.iter().all(|c| (-REACH..=REACH).contains(c)) && (0..=REACH).contains(&radius);
        let node = header.get(24..).and_then(<[u8]>::first_chunk::<6>).ok_or(BrokenModel::NoHeader)?;
        let root_node = Node::from_bytes(*node);
        if !reachable || root_node.normal >= NORMAL_CODES {
            return Err(BrokenModel::NoHeader);
        }
        let root_group = usize::try_from(word(30)?).unwrap_or(usize::MAX);
        if root_node.children > 0 && root_group < HEADER {
            return Err(BrokenModel::Backwards { offset: root_group });
        }
        Ok(Self { bytes, nodes, root: Sphere { centre, radius }, root_node, root_group })
    }

    /// How many nodes it says it has.
    #[inline]
    pub const fn nodes(&self) -> u32 {
        self.nodes
    }

    /// The sphere around all of it.
    #[inline]
    pub const fn bounds(&self) -> Sphere {
        self.root
    }

    /// A node of a group.
    #[inline(always)]
    pub(super) fn node(&self, offset: usize) -> Result<Node, BrokenModel> {
        let bytes = self.bytes.get(offset..).and_then(<[u8]>::first_chunk::<NODE>);
        let node = Node::from_bytes(*bytes.ok_or(BrokenModel::Ends { offset })?);
        if node.sphere >= SPHERE_CODES || node.normal >= NORMAL_CODES {
            return Err(BrokenModel::Code { offset });
        }
        Ok(node)
    }

    /// Where the groups below a group of so many siblings begin.
    #[inline(always)]
    pub(super) fn groups_below(&self, group: usize, siblings: u8) -> Result<usize, BrokenModel> {
        let at = group + usize::from(siblings) * NODE;
        let word = self.bytes.get(at..).and_then(<[u8]>::first_chunk::<OFFSET>);
        let word = u32::from_le_bytes(*word.ok_or(BrokenModel::Ends { offset: at })?);
        let offset = usize::try_from(word).unwrap_or(usize::MAX);
        if offset < at + OFFSET { Err(BrokenModel::Backwards { offset }) } else { Ok(offset) }
    }

    /// A sibling's place in its group.
    #[inline(always)]
    pub(super) const fn sibling(group: usize, index: u8) -> usize {
        group + index as usize * NODE
    }
}
