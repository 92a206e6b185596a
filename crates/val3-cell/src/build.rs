//! Construction of a cell from its file: things with their shapes and carriers.

use val3_geometry::IsometryMatrix3;

use crate::allowed::Allowed;
use crate::carriers::{Carried, Carrier, carriers};
use crate::error::CellError;
use crate::file::{CellFile, ObjectEntry};
use crate::poses::{check_colour, distance};
use crate::solids::{Solid, SolidMaker, solid};
use crate::surroundings::{ArmBase, Surroundings};

/// A cell.
#[derive(Debug, Clone)]
pub struct Cell {
    /// Distance in mm below which two things are too near to each other, unless one of them has its own.
    pub clearance: f64,
    /// The things.
    pub things: Vec<Thing>,
    /// Names of things whose frame or tool the application lacks.
    pub missing: Vec<String>,
    pub(crate) allowed: Allowed,
}

/// A thing.
#[derive(Debug, Clone)]
pub struct Thing {
    /// Name in messages.
    pub name: String,
    /// Its carrier.
    pub carrier: Carrier,
    /// Pose of the thing in the frame of the carrier.
    pub pose: IsometryMatrix3<f64>,
    /// Its shapes.
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
    /// A name, a carrier, a shape, or a mesh cannot be used.
    pub fn build(file: &CellFile, arm: ArmBase, surroundings: &mut dyn Surroundings) -> Result<Self, CellError> {
        let clearance = distance(file.clearance, "clearance")?;
        let carriers = carriers(&file.objects, arm, surroundings)?;
        let entries = file.objects.iter().zip(carriers).enumerate();
        let (mut things, mut missing) = (Vec::new(), Vec::new());
        for (index, (entry, carried)) in entries {
            match carried {
                Some(carried) => things.push(thing(entry, &format!("object[{index}]"), carried, &mut *surroundings)?),
                None => missing.push(entry.name.clone()),
            }
        }
        let allowed = Allowed::build(&file.allow, &file.objects, arm.axes)?;
        Ok(Self { clearance, things, missing, allowed })
    }
}

impl Cell {
    /// Names of the things.
    pub(crate) fn thing_names(&self) -> impl Iterator<Item = &str> {
        self.things.iter().map(|thing| thing.name.as_str())
    }
}

fn thing(
    entry: &ObjectEntry,
    key: &str,
    (carrier, pose): Carried,
    surroundings: &mut dyn Surroundings,
) -> Result<Thing, CellError> {
    let ObjectEntry { name, clearance, colour, .. } = entry;
    let solids = solids(entry, key, SolidMaker { surroundings, is_carried: carrier.is_arm() })?;
    let clearance = clearance.map(|least| distance(least, &format!("{key}.clearance"))).transpose()?;
    let colour = colour.as_deref().map(|colour| check_colour(colour, key)).transpose()?;
    Ok(Thing { name: name.clone(), carrier, pose, solids, clearance, colour })
}

fn solids(entry: &ObjectEntry, key: &str, mut maker: SolidMaker<'_>) -> Result<Vec<Solid>, CellError> {
    let ObjectEntry { name, shapes, shape, .. } = entry;
    let without = |key: &str, what: &str| {
        let help = "add one of `box`, `cylinder`, `sphere`, `capsule`, `mesh`: `box = [200, 100, 50]`";
        CellError::new(key, format!("{what} has no shape"), help)
    };
    match solid(shape, &[], key, &mut maker)? {
        Some(_) if !shapes.is_empty() => {
            Err(CellError::new(key, format!("`{name}` has a shape and `shapes`"), "move the shape into `shapes`"))
        }
        Some(own) => Ok(vec![own]),
        None if shapes.is_empty() => Err(without(key, &format!("`{name}`"))),
        None => {
            let several = shapes.iter().enumerate().map(|(index, several)| {
                let key = format!("{key}.shapes[{index}]");
                solid(&several.shape, &several.at, &key, &mut maker)?.ok_or_else(|| without(&key, "this shape"))
            });
            several.collect()
        }
    }
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
        // The hull of a triangle encloses nothing.
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
            object[1].name: two objects have the name `a`
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
            help: is it in mm? remove `unit = "m"`"#]],
        );
        refused(
            &mesh("no.stl", "mm"),
            expect![[r#"
                object[0].mesh: cannot read `no.stl`: it does not exist
                help: name an existing STL or GLB file of at most 32 MB"#]],
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
        assert_eq!(cell.thing_names().collect::<Vec<_>>(), ["foot"]);
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
