//! GLB reader (glTF 2.0, binary): positions and indices of triangles, and the transformations of nodes.
//!
//! Compressed and sparse data, external buffers, strips and fans are rejected. The crate `gltf` is not used, because
//! its iterators panic on damaged files, for example on a list with 0 entries or a stride that is too small.

mod document;
mod placement;

use std::collections::BTreeSet;

use val3_geometry::Vector3;

use self::document::{BufferView, Document, Primitive};
use self::placement::Placement;
use super::{MOST_TRIANGLES, Mesh, MeshError};

/// First bytes of a GLB file.
pub(super) const MAGIC: &[u8; 4] = b"glTF";

/// Header sizes of the file and of a chunk, in bytes.
const HEAD: usize = 12;
const CHUNK_HEAD: usize = 8;

const JSON: &[u8; 4] = b"JSON";
const BINARY: &[u8; 4] = b"BIN\0";

/// Component types of accessors.
const BYTE: u32 = 5121;
const SHORT: u32 = 5123;
const INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// Primitive mode of separate triangles.
const TRIANGLES: u32 = 4;

/// Nesting limit of nodes, and maximum number of placed nodes.
const DEEPEST: usize = 64;
const MOST_NODES: usize = 100_000;

/// Maximum number of points. Each node copies all points in its mesh, even points without a triangle.
const MOST_POINTS: usize = 5_000_000;

/// A parsed GLB file.
struct Glb<'b> {
    document: Document,
    binary: &'b [u8],
}

/// Returns the triangles of a file in metres, with z up.
pub(super) fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let glb = Glb::parse(bytes)?;
    let mut mesh = Mesh::default();
    let mut open: Vec<(usize, Placement, usize)> =
        glb.roots().into_iter().map(|node| (node, Placement::identity(), 0)).collect();
    let mut placed = 0;
    while let Some((number, around, depth)) = open.pop() {
        placed += 1;
        let node = glb.document.nodes.get(number).ok_or(MeshError::Glb("a node does not exist"))?;
        // Open nodes count as well, because nodes in a circle add their children again and again.
        if depth > DEEPEST || placed + open.len() + node.children.len() > MOST_NODES {
            return Err(MeshError::Glb("its nodes are too many, nested too deeply, or in a circle"));
        }
        let here = around.then(&Placement::of(node));
        if let Some(of_node) = node.mesh {
            glb.add(of_node, &here, &mut mesh)?;
        }
        open.extend(node.children.iter().map(|child| (*child, here, depth + 1)));
    }
    Ok(mesh)
}

impl<'b> Glb<'b> {
    fn parse(bytes: &'b [u8]) -> Result<Self, MeshError> {
        let mut rest = bytes.get(HEAD..).ok_or(MeshError::Glb("it is cut off"))?;
        let (mut document, mut binary) = (None, &[] as &[u8]);
        while let Some((head, body)) = rest.split_at_checked(CHUNK_HEAD) {
            let (length, kind) = head.split_at_checked(4).unwrap_or_default();
            let length = number(length).ok_or(MeshError::Glb("it is cut off"))?;
            let (chunk, next) = body.split_at_checked(length).ok_or(MeshError::Glb("it is cut off"))?;
            if kind == JSON && document.is_none() {
                let parsed = serde_json::from_slice(chunk);
                document = Some(parsed.map_err(|_| MeshError::Glb("its description is no glTF 2.0"))?);
            } else if kind == BINARY && binary.is_empty() {
                binary = chunk;
            }
            rest = next;
        }
        let document: Document = document.ok_or(MeshError::Glb("it has no description"))?;
        if !document.extensions_required.is_empty() {
            return Err(MeshError::Glb("it is compressed or needs another extension: export it without"));
        }
        if document.buffers.iter().any(|buffer| buffer.uri.is_some()) {
            return Err(MeshError::Glb("its data are in another file: export it as one file"));
        }
        Ok(Self { document, binary })
    }

    /// Returns the root nodes of the scene; in a file without scenes, all nodes that are no children.
    fn roots(&self) -> Vec<usize> {
        let Document { scene, scenes, nodes, .. } = &self.document;
        match scenes.get(scene.unwrap_or_default()) {
            Some(scene) => scene.nodes.clone(),
            None => {
                let children: BTreeSet<usize> = nodes.iter().flat_map(|node| &node.children).copied().collect();
                (0..nodes.len()).filter(|number| !children.contains(number)).collect()
            }
        }
    }

    /// Adds the triangles of a mesh with a placement.
    fn add(&self, number: usize, placement: &Placement, mesh: &mut Mesh) -> Result<(), MeshError> {
        let of_node = self.document.meshes.get(number).ok_or(MeshError::Glb("a mesh does not exist"))?;
        for Primitive { attributes, indices, mode } in &of_node.primitives {
            if mode.is_some_and(|mode| mode != TRIANGLES) {
                return Err(MeshError::Glb("it has lines, points, strips or fans: export it as triangles"));
            }
            let Some(position) = attributes.position else { continue };
            let first = u32::try_from(mesh.points.len()).map_err(|_| MeshError::TooMany(mesh.points.len()))?;
            let points = self.positions(position)?;
            if mesh.points.len() + points.len() > MOST_POINTS {
                return Err(MeshError::Glb("its nodes have too many points: export it with fewer"));
            }
            let numbers = match indices {
                Some(indices) => self.indices(*indices)?,
                None => (0..u32::try_from(points.len()).unwrap_or(u32::MAX)).collect(),
            };
            if numbers.iter().any(|number| usize::try_from(*number).is_ok_and(|number| number >= points.len())) {
                return Err(MeshError::Glb("a triangle has a corner that does not exist"));
            }
            // Converts y up to z up.
            let up = |point: Vector3<f64>| Vector3::new(point.x, -point.z, point.y);
            mesh.points.extend(points.iter().map(|point| up(placement.point(point))));
            let triangles = numbers.as_chunks::<3>().0;
            mesh.triangles.extend(triangles.iter().map(|corners| corners.map(|corner| first.saturating_add(corner))));
            if mesh.triangles.len() > MOST_TRIANGLES {
                return Err(MeshError::TooMany(mesh.triangles.len()));
            }
        }
        Ok(())
    }

    fn positions(&self, accessor: usize) -> Result<Vec<Vector3<f64>>, MeshError> {
        let entries = self.entries(accessor, "VEC3", &[FLOAT])?;
        Ok(entries.into_iter().map(point).collect())
    }

    fn indices(&self, accessor: usize) -> Result<Vec<u32>, MeshError> {
        let entries = self.entries(accessor, "SCALAR", &[BYTE, SHORT, INT])?;
        Ok(entries
            .into_iter()
            .map(|entry| number(entry).and_then(|number| number.try_into().ok()).unwrap_or(u32::MAX))
            .collect())
    }

    /// Returns the bytes of all entries in an accessor, which has the type `form` and one of the component types.
    fn entries(&self, accessor: usize, form: &str, types: &[u32]) -> Result<Vec<&'b [u8]>, MeshError> {
        let Document { accessors, buffer_views, .. } = &self.document;
        let accessor = accessors.get(accessor).ok_or(MeshError::Glb("a list of numbers does not exist"))?;
        if accessor.sparse.is_some() || accessor.form != form || !types.contains(&accessor.component_type) {
            return Err(MeshError::Glb("its numbers have a form that is not supported: export it without compression"));
        }
        let cut = MeshError::Glb("its data are cut off");
        let view = accessor.buffer_view.and_then(|view| buffer_views.get(view)).filter(|view| view.buffer == 0);
        let BufferView { byte_offset, byte_length, byte_stride, .. } = view.ok_or(cut)?;
        let bytes =
            byte_offset.checked_add(*byte_length).and_then(|end| self.binary.get(*byte_offset..end)).ok_or(cut)?;
        if accessor.count > bytes.len() {
            return Err(cut);
        }
        let size = if form == "VEC3" { 3 } else { 1 } * size_of_component(accessor.component_type);
        let layout = EntryLayout { offset: accessor.byte_offset, stride: byte_stride.unwrap_or(size).max(1), size };
        (0..accessor.count).map(|index| layout.entry(bytes, index).ok_or(cut)).collect()
    }
}

/// Layout of an accessor's entries in their buffer view. All lengths are in bytes.
struct EntryLayout {
    /// Start of the first entry.
    offset: usize,
    /// Distance between the starts of consecutive entries.
    stride: usize,
    /// Size of an entry.
    size: usize,
}

impl EntryLayout {
    /// Returns the bytes of the entry with this index; `None` if the view is too short.
    fn entry<'b>(&self, view: &'b [u8], index: usize) -> Option<&'b [u8]> {
        let start = index.checked_mul(self.stride)?.checked_add(self.offset)?;
        view.get(start..start.checked_add(self.size)?)
    }
}

/// Reads the coordinates of a point, three numbers of four bytes; the origin if the entry has another size.
fn point(entry: &[u8]) -> Vector3<f64> {
    let coordinates = entry.as_chunks::<4>().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes)));
    <[f64; 3]>::try_from(coordinates.collect::<Vec<f64>>()).unwrap_or_default().into()
}

const fn size_of_component(component: u32) -> usize {
    match component {
        BYTE => 1,
        SHORT => 2,
        _ => 4,
    }
}

/// Reads an unsigned number from one, two or four bytes.
fn number(bytes: &[u8]) -> Option<usize> {
    let value = match *bytes {
        [a] => u32::from(a),
        [a, b] => u32::from(u16::from_le_bytes([a, b])),
        [a, b, c, d] => u32::from_le_bytes([a, b, c, d]),
        _ => return None,
    };
    usize::try_from(value).ok()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// File with this JSON description and these bytes.
    fn glb(description: &str, binary: &[u8]) -> Vec<u8> {
        let chunk = |kind: &[u8; 4], content: &[u8]| {
            let length = u32::try_from(content.len()).unwrap().to_le_bytes();
            [&length, kind.as_slice(), content].concat()
        };
        let chunks = [chunk(JSON, description.as_bytes()), chunk(BINARY, binary)].concat();
        let length = u32::try_from(HEAD + chunks.len()).unwrap().to_le_bytes();
        [MAGIC.as_slice(), &2u32.to_le_bytes(), &length, &chunks].concat()
    }

    /// A triangle with corners at (1, 0, 0), (0, 2, 0), (0, 0, 3), and its indices.
    fn triangle() -> Vec<u8> {
        let corners: [f32; 9] = [1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0];
        let indices: [u16; 3] = [2, 1, 0];
        let corners = corners.iter().flat_map(|number| number.to_le_bytes());
        corners.chain(indices.iter().flat_map(|number| number.to_le_bytes())).collect()
    }

    const PARTS: &str = r#""meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                     {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
        "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],"buffers":[{"byteLength":42}]"#;

    fn file(nodes: &str) -> Vec<u8> {
        glb(&format!("{{\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{nodes}],{PARTS}}}"), &triangle())
    }

    fn corners(nodes: &str) -> Vec<[f64; 3]> {
        let mesh = Mesh::read(&file(nodes)).unwrap();
        assert_eq!(mesh.triangles, [[2, 1, 0]]);
        mesh.points.iter().map(|point| (*point).into()).collect()
    }

    #[test]
    fn y_becomes_z() {
        assert_eq!(corners("{\"mesh\":0}"), [[1.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, -3.0, 0.0]]);
    }

    #[test]
    fn nodes_place_their_children() {
        let turned = "{\"children\":[1],\"translation\":[10,0,0]},{\"mesh\":0,\"scale\":[2,1,1]}";
        assert_eq!(corners(turned), [[12.0, 0.0, 0.0], [10.0, 0.0, 2.0], [10.0, -3.0, 0.0]]);
        // A half turn around y, as quaternion and as matrix.
        let half = [[-1.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 3.0, 0.0]];
        assert_eq!(corners("{\"mesh\":0,\"rotation\":[0,1,0,0]}"), half);
        assert_eq!(corners("{\"mesh\":0,\"matrix\":[-1,0,0,0,0,1,0,0,0,0,-1,0,0,0,0,1]}"), half);
    }

    #[test]
    fn files_that_cannot_be_used_are_rejected() {
        let reason = |bytes: &[u8]| Mesh::read(bytes).unwrap_err().to_string();
        let description = |parts: &str| glb(&format!("{{\"nodes\":[{{\"mesh\":0}}],{parts}}}"), &triangle());
        assert!(
            reason(&description(&PARTS.replace("\"count\":3,\"type\":\"VEC3\"", "\"count\":4,\"type\":\"VEC3\"")))
                .contains("cut off")
        );
        assert!(reason(&description(&PARTS.replace("5126", "5122"))).contains("not supported"));
        assert!(reason(&description(&PARTS.replace("\"indices\":1", "\"indices\":1,\"mode\":5"))).contains("strips"));
        assert!(
            reason(&description(&format!("\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],{PARTS}")))
                .contains("compressed")
        );
        assert!(
            reason(&description(&PARTS.replace("{\"byteLength\":42}", "{\"uri\":\"a.bin\"}"))).contains("another file")
        );
        assert!(reason(&file("{\"mesh\":0,\"children\":[0]}")).contains("circle"));
        let wide = vec!["0"; 2000].join(",");
        assert!(reason(&file(&format!("{{\"mesh\":0,\"children\":[{wide}]}}"))).contains("circle"));
        assert!(reason(&file("{\"children\":[7]}")).contains("a node"));
        assert!(reason(&file("{}")).contains("no triangle"));
        assert!(reason(&glb("{", &[])).contains("no glTF"));
        assert!(reason(b"glTF").contains("cut off"));
        let mut indices = triangle();
        indices[36] = 3;
        let description = format!("{{\"nodes\":[{{\"mesh\":0}}],{PARTS}}}");
        assert!(reason(&glb(&description, &indices)).contains("corner"));
    }

    #[test]
    fn entries_begin_at_the_offset_and_end_within_the_view() {
        let view: [u8; 11] = std::array::from_fn(|index| u8::try_from(index).unwrap());
        let layout = EntryLayout { offset: 1, stride: 4, size: 2 };
        assert_eq!([0, 1, 2].map(|index| layout.entry(&view, index).unwrap()), [[1, 2], [5, 6], [9, 10]]);
        assert_eq!(layout.entry(&view[..10], 2), None);
        assert_eq!(layout.entry(&view, usize::MAX), None);
    }

    /// Without a scene, the nodes that are no children of others are the roots.
    #[test]
    fn a_file_without_a_scene_has_all_nodes() {
        let nodes = "{\"children\":[2]},{},{\"mesh\":0}";
        let mesh = Mesh::read(&glb(&format!("{{\"nodes\":[{nodes}],{PARTS}}}"), &triangle())).unwrap();
        assert_eq!(mesh.triangles, [[2, 1, 0]]);
        let too_many = vec!["{}"; MOST_NODES + 2].join(",");
        let error = Mesh::read(&glb(&format!("{{\"nodes\":[{too_many}],{PARTS}}}"), &triangle())).unwrap_err();
        assert!(error.to_string().contains("too many"), "{error}");
    }

    /// The triangles are few, but each node has all points.
    #[test]
    fn the_points_of_all_nodes_are_limited() {
        let points = 300_000;
        let mut bytes = vec![0; 12 * points];
        bytes.extend([0, 1, 2]);
        let nodes = vec!["{\"mesh\":0}"; MOST_POINTS / points + 1].join(",");
        let parts = PARTS
            .replace("\"count\":3,\"type\":\"VEC3\"", &format!("\"count\":{points},\"type\":\"VEC3\""))
            .replace("5123", "5121")
            .replace("36", &bytes.len().saturating_sub(3).to_string())
            .replace("\"byteLength\":6}", "\"byteLength\":3}");
        let error = Mesh::read(&glb(&format!("{{\"nodes\":[{nodes}],{parts}}}"), &bytes)).unwrap_err();
        assert!(error.to_string().contains("too many points"), "{error}");
    }

    proptest! {
        #[test]
        fn damaged_files_are_rejected_or_read(at in 0usize..700, byte in any::<u8>(), cut in 0usize..700) {
            let mut bytes = file("{\"children\":[1],\"translation\":[10,0,0]},{\"mesh\":0,\"scale\":[2,1,1]}");
            let (at, cut) = (at % bytes.len(), cut % bytes.len());
            bytes[at] = byte;
            let _ = Mesh::read(&bytes);
            bytes.truncate(cut);
            let _ = Mesh::read(&bytes);
        }
    }
}
