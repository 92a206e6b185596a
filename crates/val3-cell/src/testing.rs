//! Cells and arms for tests.

use std::sync::Arc;

use camino::Utf8Path;
use val3_kinematics::{Arm, Joints};

use crate::build::Cell;
use crate::error::CellError;
use crate::file::CellFile;
use crate::mesh::Mesh;
use crate::scene::Scene;
use crate::step::Sight;
use crate::surroundings::{ArmBase, DataKind, KnownSignal, SignalClass, Surroundings};

/// An application with the frames `fTable` and `fPart`, the tool `tGripper`, and the mesh file `fin.stl`, also in two
/// other sizes.
pub(crate) struct Application {
    pub(crate) may_lack_data: bool,
}

/// A triangle with corners at (0, 0, 0), (10, 0, 0), (0, 5, 0).
const FIN: &str = "solid fin\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 5 0\n\
                   endloop\nendfacet\nendsolid fin\n";

impl Surroundings for Application {
    fn mesh(&mut self, path: &Utf8Path) -> Result<Mesh, String> {
        let fin =
            |factor| Mesh::read(FIN.as_bytes()).map(|mesh| mesh.scaled(factor)).map_err(|error| error.to_string());
        match path.as_str() {
            "fin.stl" => fin(1.0),
            "tiny.stl" => fin(0.1),
            "huge.stl" => fin(100.0),
            _ => Err(format!("cannot read `{path}`: it does not exist")),
        }
    }

    fn carrier(&self, name: &str) -> Result<DataKind, Option<String>> {
        match name {
            "fTable" | "fPart" => Ok(DataKind::Frame),
            "tGripper" => Ok(DataKind::Tool),
            "ftable" => Err(Some("fTable".to_owned())),
            _ => Err(None),
        }
    }

    fn signal(&self, path: &str) -> Result<KnownSignal, Option<String>> {
        let digital = |is_output| Ok(KnownSignal { class: SignalClass::Digital, is_output });
        match path {
            "valve" => digital(true),
            "diPart" => digital(false),
            "aiVacuum" => Ok(KnownSignal { class: SignalClass::Analog, is_output: false }),
            "dipart" => Err(Some("diPart".to_owned())),
            _ => Err(None),
        }
    }

    fn may_lack_data(&self) -> bool {
        self.may_lack_data
    }
}

pub(crate) fn arm(name: &str) -> Arc<Arm> {
    Arc::new(Arm::by_name(name).unwrap())
}

pub(crate) fn build(text: &str, arm: &Arm) -> Result<Cell, CellError> {
    let file: CellFile = toml::from_str(text).unwrap();
    Cell::build(&file, ArmBase { axes: arm.axes(), height: arm.height() }, &mut Application { may_lack_data: false })
}

pub(crate) fn scene(text: &str, arm: &Arc<Arm>) -> Scene {
    Scene::new(Arc::new(build(text, arm).unwrap()), Arc::clone(arm))
}

/// A sight without frames and tools.
pub(crate) fn sight(arm: &Arc<Arm>, joints: Joints, time: f64) -> Sight<'_> {
    Sight { arm, joints, placement: 0, places: Vec::new(), parts: Arc::default(), time }
}
