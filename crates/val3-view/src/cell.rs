//! Objects and parts of the cell, for pages.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use val3_cell::{Carrier, Cell, Mesh, Part, Solid, SolidForm, Thing};
use val3_geometry::IsometryMatrix3;
use val3_machine::controller::{Controller, PartState};

use crate::coordinates;
use crate::wire::{CellObject, CellPart, ObjectCarrier, ObjectShape, PartPlace, PartsMessage};

/// Returns the things of a cell: objects and conveyor belts.
pub(crate) fn objects(cell: &Cell) -> Vec<CellObject> {
    cell.things.iter().map(object).collect()
}

fn object(thing: &Thing) -> CellObject {
    CellObject {
        name: thing.name.clone(),
        colour: thing.colour.clone(),
        carrier: carrier(&thing.carrier),
        shapes: thing.solids.iter().map(|solid| shape(&thing.pose, solid)).collect(),
    }
}

/// Returns the parts of a cell.
pub(crate) fn parts(cell: &Cell) -> Vec<CellPart> {
    cell.parts.iter().map(part).collect()
}

fn part(part: &Part) -> CellPart {
    CellPart {
        name: part.name.clone(),
        colour: part.colour.clone(),
        shapes: part.solids.iter().map(|solid| shape(&IsometryMatrix3::identity(), solid)).collect(),
    }
}

/// Returns the message with the carriers and poses of all parts; `None` without parts.
pub(crate) fn places(t: f64, controller: &Controller) -> Option<PartsMessage> {
    let parts: Vec<PartPlace> = controller.parts().into_iter().map(place).collect();
    (!parts.is_empty()).then_some(PartsMessage { t, parts })
}

fn place(part: PartState) -> PartPlace {
    PartPlace { carrier: part.carrier.as_ref().map(carrier), pose: coordinates(&part.pose), name: part.name }
}

fn carrier(carrier: &Carrier) -> ObjectCarrier {
    match carrier {
        Carrier::World => ObjectCarrier::World,
        Carrier::Frame(name) => ObjectCarrier::Frame { name: name.clone() },
        Carrier::Flange => ObjectCarrier::Flange,
        Carrier::Tool(name) => ObjectCarrier::Tool { name: name.clone() },
        Carrier::Link(link) => ObjectCarrier::Link { link: *link },
    }
}

fn shape(place: &IsometryMatrix3<f64>, solid: &Solid) -> ObjectShape {
    let pose = coordinates(&(place * solid.pose));
    match &solid.form {
        SolidForm::Box(size) => ObjectShape::Box { pose, size: *size },
        SolidForm::Cylinder { radius, length } => ObjectShape::Cylinder { pose, radius: *radius, length: *length },
        SolidForm::Capsule { from, to, radius } => ObjectShape::Capsule { pose, from: *from, to: *to, radius: *radius },
        SolidForm::Mesh(mesh) => ObjectShape::Mesh { pose, corners: corners(mesh) },
    }
}

/// Returns the corners of all triangles in base64, as 32-bit numbers because pages draw with this precision.
fn corners(mesh: &Mesh) -> String {
    let corners = mesh.triangles.iter().flatten().filter_map(|corner| mesh.points.get(*corner as usize));
    let bytes = corners.flat_map(|point| [point.x, point.y, point.z]).flat_map(|length| (length as f32).to_le_bytes());
    BASE64_STANDARD.encode(bytes.collect::<Vec<u8>>())
}

#[cfg(test)]
mod tests {
    use val3_cell::{ArmBase, CellFile, DataKind, KnownSignal, Surroundings};

    use val3_tests::running::Running;

    use super::*;

    /// An application with the frame `fPallet`, and a mesh with one triangle.
    struct Application;

    impl Surroundings for Application {
        fn mesh(&mut self, _: &camino::Utf8Path) -> Result<Mesh, String> {
            let points = vec![[0.0; 3].into(), [100.0, 0.0, 0.0].into(), [0.0, 20.0, 30.0].into()];
            Ok(Mesh { points, triangles: vec![[0, 1, 2]] })
        }

        fn carrier(&self, name: &str) -> Result<DataKind, Option<String>> {
            if name == "fPallet" { Ok(DataKind::Frame) } else { Err(None) }
        }

        fn signal(&self, _: &str) -> Result<KnownSignal, Option<String>> {
            Err(None)
        }
    }

    #[test]
    fn parts_have_their_carriers_and_poses_in_the_run() {
        let file = "[[part]]\nname = \"carton\"\nin = \"fPallet\"\nat = [1, 2, 3]\nbox = [10, 20, 30]\n";
        let file: CellFile = toml::from_str(file).unwrap();
        let cell = Cell::build(&file, ArmBase { axes: 6, height: 478.0 }, &mut Application).unwrap();
        let mut controller = Running::start("frame fPallet\nprogram start()\nbegin\nend\n").controller;
        assert!(places(0.0, &controller).is_none());
        controller.surround(cell);
        let message = places(0.5, &controller).unwrap();
        let [part] = message.parts.as_slice() else { panic!("{message:?}") };
        assert_eq!((message.t, part.name.as_str()), (0.5, "carton"));
        assert_eq!(part.carrier, Some(ObjectCarrier::Frame { name: "fPallet".to_owned() }));
        assert_eq!(part.pose, [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn things_have_their_carriers_and_the_poses_of_their_shapes() {
        let file: CellFile = toml::from_str(
            "[[object]]\nname = \"box\"\nin = \"fPallet\"\nat = [1, 2, 3]\nbox = { min = [0, 0, 0], max = [10, 20, 30] }\n\
             [[object]]\nname = \"fin\"\ncolour = \"#d9a400\"\nmesh = \"fin.stl\"\n",
        )
        .unwrap();
        let cell = Cell::build(&file, ArmBase { axes: 6, height: 478.0 }, &mut Application).unwrap();
        let objects = objects(&cell);
        let [first, second] = objects.as_slice() else { panic!("{objects:?}") };
        assert_eq!(first.carrier, ObjectCarrier::Frame { name: "fPallet".to_owned() });
        let pose = [6.0, 12.0, 18.0, 0.0, 0.0, 0.0];
        assert_eq!(first.shapes, [ObjectShape::Box { pose, size: [10.0, 20.0, 30.0] }]);
        assert_eq!((second.carrier.clone(), second.colour.as_deref()), (ObjectCarrier::World, Some("#d9a400")));
        let ObjectShape::Mesh { corners, .. } = &second.shapes[0] else { panic!("{second:?}") };
        assert_eq!(BASE64_STANDARD.decode(corners).unwrap().len(), 3 * 3 * 4);
    }
}
