//! Construction of a cell from its file: things, parts, grippers, sensors, conveyors.

mod conveyors;
mod grippers;
mod parts;
mod sensors;
mod signals;

use val3_geometry::IsometryMatrix3;

use self::conveyors::FedParts;
use crate::allowed::Allowed;
use crate::carriers::{Carried, Carrier, Carriers};
use crate::conveyor::Conveyor;
use crate::error::CellError;
use crate::file::{CellFile, ObjectEntry};
use crate::gripper::Gripper;
use crate::links::LinkHull;
use crate::names::GivenNames;
use crate::part::Part;
use crate::poses::{check_colour, distance};
use crate::sensor::Sensor;
use crate::solids::{ShapedEntry, Solid, SolidMaker, solids};
use crate::surroundings::{ArmBase, Surroundings};

/// A checked cell: a file whose names, carriers, shapes and signals were resolved.
#[derive(Debug, Clone)]
pub struct Cell {
    /// Distance in mm below which two things are too near to each other, unless one of them has its own clearance.
    pub clearance: f64,
    /// Objects of the file, then the conveyor belts.
    pub things: Vec<Thing>,
    /// The parts.
    pub parts: Vec<Part>,
    /// The grippers.
    pub grippers: Vec<Gripper>,
    /// The sensors.
    pub sensors: Vec<Sensor>,
    /// The conveyors. Each belt is also a thing.
    pub conveyors: Vec<Conveyor>,
    /// Names of the entries that were omitted because the application has no such frame, tool or signal.
    pub missing: Vec<String>,
    /// Hulls of the base and the links, which replace the capsules in the arm's description; `None` keeps the capsules.
    pub(crate) links: Vec<Option<LinkHull>>,
    pub(crate) allowed: Allowed,
}

/// An object of the file, or a conveyor belt.
#[derive(Debug, Clone)]
pub struct Thing {
    /// Name in messages.
    pub name: String,
    /// Carrier, relative to which the pose is constant.
    pub carrier: Carrier,
    /// Pose of the thing in the carrier's frame.
    pub pose: IsometryMatrix3<f64>,
    /// Shapes.
    pub solids: Vec<Solid>,
    /// Distance in mm below which something is too near to this thing.
    pub clearance: Option<f64>,
    /// Colour as `#rrggbb`.
    pub colour: Option<String>,
}

impl Cell {
    /// Builds the cell that a file describes.
    ///
    /// # Errors
    /// A name, a carrier, a shape, a signal, or a mesh cannot be used.
    pub fn build(file: &CellFile, arm: ArmBase, surroundings: &mut dyn Surroundings) -> Result<Self, CellError> {
        let clearance = distance(file.clearance, "clearance")?;
        check_names(file)?;
        let carriers = Carriers::build(&file.objects, arm, surroundings)?;
        let mut missing = Vec::new();
        let mut things = Vec::new();
        for (index, entry) in file.objects.iter().enumerate() {
            match carriers.of_object(index) {
                Some(carried) => things.push(thing(entry, &format!("object[{index}]"), carried, &mut *surroundings)?),
                None => missing.push(entry.name.clone()),
            }
        }
        let mut maker = CellMaker { carriers: &carriers, surroundings, missing: &mut missing };
        let fed = conveyors::fed_parts(file)?;
        let parts = maker.parts(&file.parts, &fed)?;
        let fed_parts = FedParts { entries: &file.parts, parts: &parts };
        let (conveyors, belts): (Vec<_>, Vec<_>) = maker.conveyors(&file.conveyors, fed_parts)?.into_iter().unzip();
        let names: Vec<&str> = file.objects.iter().map(|object| object.name.as_str()).collect();
        let grippers = maker.grippers(&file.grippers, &things, &names)?;
        things.extend(belts);
        let belts = file.conveyors.iter().map(|conveyor| conveyor.name.clone());
        let parts_of_file = file.parts.iter().flat_map(parts::names);
        let bodies: Vec<String> = names.into_iter().map(str::to_owned).chain(belts).chain(parts_of_file).collect();
        let sensors = maker.sensors(&file.sensors, &bodies, arm.axes)?;
        let allowed = Allowed::build(&file.allow, &bodies, arm.axes)?;
        Ok(Self { clearance, things, parts, grippers, sensors, conveyors, missing, links: Vec::new(), allowed })
    }

    /// Returns the cell with these hulls of the base and the links. `None` keeps the capsules in the arm's description.
    #[must_use]
    pub fn with_links(self, links: Vec<Option<LinkHull>>) -> Self {
        Self { links, ..self }
    }

    /// Returns the names of the things, then of the parts.
    pub(crate) fn body_names(&self) -> impl Iterator<Item = &str> {
        let things = self.things.iter().map(|thing| thing.name.as_str());
        things.chain(self.parts.iter().map(|part| part.name.as_str()))
    }

    /// Returns the index of the part with a name.
    #[must_use]
    pub fn part(&self, name: &str) -> Option<usize> {
        self.parts.iter().position(|part| part.name == name)
    }
}

/// Context in which parts, grippers, sensors and conveyors are built.
pub(crate) struct CellMaker<'m> {
    carriers: &'m Carriers<'m>,
    surroundings: &'m mut dyn Surroundings,
    /// Names of the entries whose frame, tool or signal the application does not have.
    missing: &'m mut Vec<String>,
}

fn check_names(file: &CellFile) -> Result<(), CellError> {
    let mut names = GivenNames::default();
    let mut add = |name: &String, kind: &str, index: usize| names.add(name, kind, index);
    file.objects.iter().enumerate().try_for_each(|(index, object)| add(&object.name, "object", index))?;
    file.parts.iter().enumerate().try_for_each(|(index, part)| add(&part.name, "part", index))?;
    file.conveyors.iter().enumerate().try_for_each(|(index, conveyor)| add(&conveyor.name, "conveyor", index))?;
    file.sensors.iter().enumerate().try_for_each(|(index, sensor)| add(&sensor.name, "sensor", index))
}

fn thing(
    entry: &ObjectEntry,
    key: &str,
    carried: Carried,
    surroundings: &mut dyn Surroundings,
) -> Result<Thing, CellError> {
    let ObjectEntry { name, clearance, colour, shapes, shape, .. } = entry;
    let Carried { carrier, pose } = carried;
    let maker = SolidMaker { surroundings, is_carried: carrier.is_arm() };
    let solids = solids(ShapedEntry { name, shapes, shape }, key, maker)?;
    let clearance = clearance.map(|least| distance(least, &format!("{key}.clearance"))).transpose()?;
    let colour = colour.as_deref().map(|colour| check_colour(colour, key)).transpose()?;
    Ok(Thing { name: name.clone(), carrier, pose, solids, clearance, colour })
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use crate::build::Cell;
    use crate::carriers::Carrier;
    use crate::surroundings::ArmBase;
    use crate::testing::{Application, arm, build};

    #[track_caller]
    fn refused(text: &str, expected: Expect) {
        let error = build(text, &arm("tx2-60l")).unwrap_err();
        expected.assert_eq(&format!("{error}\nhelp: {}", error.help));
    }

    const SPHERE: &str = "sphere = { radius = 10 }";

    #[test]
    fn a_thing_is_carried_by_what_in_names() {
        let carrier = |name: &str| {
            let text = format!("[[object]]\nname = \"thing\"\nin = \"{name}\"\n{SPHERE}");
            build(&text, &arm("tx2-60l")).unwrap().things.remove(0).carrier
        };
        assert_eq!(carrier("world"), Carrier::World);
        assert_eq!(carrier("link3"), Carrier::Link(3));
        assert_eq!(carrier("flange"), Carrier::Flange);
        assert_eq!(carrier("fTable"), Carrier::Frame("fTable".to_owned()));
        assert_eq!(carrier("tGripper"), Carrier::Tool("tGripper".to_owned()));
    }

    #[test]
    fn the_base_is_below_world_by_the_height_of_the_arm() {
        let arm = arm("tx2-60l");
        let cell =
            build(&format!("[[object]]\nname = \"foot\"\nin = \"base\"\nat = [1, 2, 3]\n{SPHERE}"), &arm).unwrap();
        let place: [f64; 3] = cell.things[0].pose.translation.vector.into();
        assert_eq!(place, [1.0, 2.0, 3.0 - arm.height()]);
    }

    #[test]
    fn things_on_things_add_their_poses() {
        let text = format!(
            "[[object]]\nname = \"bolt\"\nin = \"plate\"\nat = [10, 0, 0]\n{SPHERE}\n\
             [[object]]\nname = \"plate\"\nin = \"fTable\"\nat = [0, 0, 5, 0, 0, 90]\nbox = [100, 100, 10]"
        );
        let cell = build(&text, &arm("tx2-60l")).unwrap();
        let bolt = &cell.things[0];
        assert_eq!(bolt.carrier, Carrier::Frame("fTable".to_owned()));
        assert!((bolt.pose.translation.vector - val3_geometry::Vector3::new(0.0, 10.0, 5.0)).norm() < 1e-9);
    }

    #[test]
    fn a_mesh_that_stands_is_its_surface() {
        let is_surface = |carrier: &str, more: &str| {
            let text = format!("[[object]]\nname = \"fin\"\nin = \"{carrier}\"\nmesh = \"fin.stl\"\n{more}");
            build(&text, &arm("tx2-60l")).map(|cell| cell.things[0].solids[0].shape.is_surface())
        };
        assert_eq!(is_surface("world", ""), Ok(true));
        assert_eq!(is_surface("flange", "hull = false"), Ok(true));
        // A single triangle has no hull with a volume.
        assert!(is_surface("flange", "").unwrap_err().message.contains("one plane"));
    }

    #[test]
    fn names_are_needed_and_unique() {
        refused(
            "[[object]]\nbox = [1, 2, 3]",
            expect![[r#"
            object[0].name: object 1 has no name
            help: add `name = "…"`: messages use it"#]],
        );
        let twice = format!("[[object]]\nname = \"a\"\n{SPHERE}\n[[object]]\nname = \"a\"\n{SPHERE}");
        refused(
            &twice,
            expect![[r#"
            object[1].name: two things have the name `a`
            help: rename one of them"#]],
        );
        refused(
            &format!("[[object]]\nname = \"link2\"\n{SPHERE}"),
            expect![[r#"
            object[0].name: `link2` is a part of the robot
            help: choose another name"#]],
        );
    }

    #[test]
    fn unknown_carriers_have_a_suggestion() {
        refused(
            &format!("[[object]]\nname = \"a\"\nin = \"ftable\"\n{SPHERE}"),
            expect![[r#"
            object[0].in: there is no frame, tool or object `ftable`
            help: did you mean `fTable`?"#]],
        );
        refused(
            &format!("[[object]]\nname = \"a\"\nin = \"link7\"\n{SPHERE}"),
            expect![[r#"
            object[0].in: the arm has no `link7`
            help: its links are `link1` to `link6`"#]],
        );
        refused(
            &format!("[[object]]\nname = \"fTable\"\n{SPHERE}\n[[object]]\nname = \"b\"\nin = \"fTable\"\n{SPHERE}"),
            expect![[r#"
            object[1].in: `fTable` is an object of this file and a frame of the application
            help: rename the object"#]],
        );
        let circle =
            format!("[[object]]\nname = \"a\"\nin = \"b\"\n{SPHERE}\n[[object]]\nname = \"b\"\nin = \"a\"\n{SPHERE}");
        refused(
            &circle,
            expect![[r#"
            object[0].in: `a` is carried by itself
            help: one of these objects needs another `in`"#]],
        );
    }

    #[test]
    fn shapes_are_needed_and_possible() {
        refused(
            "[[object]]\nname = \"a\"",
            expect![[r#"
            object[0]: `a` has no shape
            help: add one of `box`, `cylinder`, `sphere`, `capsule`, `mesh`: `box = [200, 100, 50]`"#]],
        );
        refused(
            &format!("[[object]]\nname = \"a\"\nbox = [1, 2, 3]\n{SPHERE}"),
            expect![[r#"
            object[0].sphere: `box` and `sphere` are two shapes
            help: list them: `shapes = [{ … }, { … }]`"#]],
        );
        refused(
            "[[object]]\nname = \"a\"\nbox = [1, 0, 3]",
            expect![[r#"
            object[0].box: it is no shape: a length is not greater than 0
            help: "#]],
        );
        refused(
            "[[object]]\nname = \"a\"\nat = [1, 2]\nbox = [1, 1, 3]",
            expect![[r#"
            object[0].at: a pose has 3 or 6 numbers, and this has 2
            help: write `[x, y, z]` or `[x, y, z, rx, ry, rz]`"#]],
        );
    }

    #[test]
    fn no_shape_is_larger_than_a_cell() {
        refused(
            "[[object]]\nname = \"a\"\nsphere = { radius = 1e300 }",
            expect![[r#"
                object[0].sphere: a number of this shape is too large
                help: 1000000 mm are the limit"#]],
        );
        for shape in ["box = [1, 1, 1e7]", "cylinder = { radius = 1, length = inf }"] {
            let error = build(&format!("[[object]]\nname = \"a\"\n{shape}"), &arm("tx2-60l")).unwrap_err();
            assert!(error.message.contains("too large"), "{shape}: {error}");
        }
    }

    #[test]
    fn a_beam_has_a_length() {
        refused(
            "[[sensor]]\nname = \"gate\"\nbeam = { from = [0, 1, 2], to = [0, 1, 2] }",
            expect![[r#"
                sensor[0].beam: the beam of `gate` begins and ends at the same point
                help: write two different points"#]],
        );
    }

    #[test]
    fn a_mesh_in_another_unit_is_recognised_by_its_size() {
        let mesh = |file: &str, unit: &str| format!("[[object]]\nname = \"a\"\nmesh = \"{file}\"\nunit = \"{unit}\"");
        refused(
            &mesh("tiny.stl", "mm"),
            expect![[r#"
            object[0].mesh: `tiny.stl` is 1.12 mm long
            help: is it in metres? add `unit = "m"`"#]],
        );
        refused(
            &mesh("huge.stl", "m"),
            expect![[r#"
                object[0].mesh: `huge.stl` is 1118033.99 mm long
                help: is it in mm? set `unit = "mm"`"#]],
        );
        refused(
            &mesh("no.stl", "mm"),
            expect![[r#"
                object[0].mesh: cannot read `no.stl`: it does not exist
                help: name an existing STL or GLB file of at most 32 MB, in the folder of this file or below"#]],
        );
    }

    #[test]
    fn things_of_another_application_are_left_out() {
        let text = format!(
            "allow = [[\"bolt\", \"foot\"]]\n[[object]]\nname = \"bolt\"\nin = \"plate\"\n{SPHERE}\n\
             [[object]]\nname = \"plate\"\nin = \"fElsewhere\"\n{SPHERE}\n[[object]]\nname = \"foot\"\n{SPHERE}"
        );
        let file = toml::from_str(&text).unwrap();
        let arm = ArmBase { axes: 6, height: 375.0 };
        let cell = Cell::build(&file, arm, &mut Application { may_lack_data: true }).unwrap();
        assert_eq!(cell.missing, ["bolt", "plate"]);
        assert_eq!(cell.body_names().collect::<Vec<_>>(), ["foot"]);
        let named = Cell::build(&file, arm, &mut Application { may_lack_data: false });
        assert!(named.unwrap_err().message.contains("`fElsewhere`"));
    }

    #[test]
    fn exceptions_name_things_of_the_cell() {
        refused(
            &format!("allow = [[\"arm\", \"raek\"]]\n[[object]]\nname = \"rack\"\n{SPHERE}"),
            expect![[r#"
            allow[0]: the cell has nothing with the name `raek`
            help: it has `base`, `link1`, `link2`, `link3`, `link4`, `link5`, `link6`, `rack`"#]],
        );
    }
}
