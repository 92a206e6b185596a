//! The arm of an application, and the positions that it can reach.

use std::cell::RefCell;
use std::rc::Rc;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::arm::{ProjectArm, arm};
use val3_analysis::db::{Db, Project};
use val3_analysis::items::positions::{Position, positions};
use val3_analysis::items::project::data_files;
use val3_analysis::placement::placement;
use val3_analysis::reach::reach;
use val3_analysis::targets::targets;
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints, RequestedConfiguration, Unreachable};
use val3_lang::types::{self, BaseType};

use super::ProjectView;

/// A tool with its centre point on the flange.
#[derive(Debug, Clone)]
pub(crate) struct Tool {
    /// Its path in the data; `None` for the flange.
    pub(crate) path: Option<String>,
    /// The flange, seen from the centre point.
    to_flange: IsometryMatrix3<f64>,
}

impl Tool {
    fn new(path: Option<String>, pose: IsometryMatrix3<f64>) -> Self {
        Self { path, to_flange: pose.inverse() }
    }
}

/// The arm of a project; `None` if the one that its configuration names cannot be used.
pub(crate) fn of_project(db: &dyn Db, project: Project) -> Option<&ProjectArm> {
    arm(db, project).as_ref().ok()
}

/// The range of an axis (counted from 1) in words.
pub(crate) fn range(arm: &Arm, axis: usize, [min, max]: [f64; 2]) -> String {
    let unit = if arm.is_stroke(axis.saturating_sub(1)) { "mm" } else { "degrees" };
    format!("{min} to {max} {unit}")
}

/// The positions of data files that an arm can be asked about.
pub(crate) struct Reach<'a> {
    view: &'a ProjectView<'a>,
    pub(crate) arm: &'a Arm,
    /// The flange and every tool of the project whose data no program changes.
    tools: Rc<[Tool]>,
    /// The uses of data by their names: those of all values of a container are equal.
    uses: RefCell<FxHashMap<String, DataUse>>,
}

/// How programs use data as targets.
#[derive(Debug, Clone)]
struct DataUse {
    is_target: bool,
    tools: Rc<[Tool]>,
}

impl<'a> Reach<'a> {
    pub(crate) fn new(view: &'a ProjectView<'a>) -> Option<Self> {
        let arm = &of_project(view.db, view.project)?.model;
        let mut tools = vec![Tool::new(None, IsometryMatrix3::identity())];
        let mut paths: Vec<_> = data_files(view.db, view.project)
            .iter()
            .flat_map(|file| positions(view.db, *file))
            .filter(|(_, position)| position.ty == BaseType::Tool)
            .map(|(path, _)| path)
            .collect();
        paths.sort_unstable();
        tools.extend(
            paths
                .into_iter()
                .filter_map(|path| Some(Tool::new(Some(path.to_string()), constant_placement(view, path)?))),
        );
        Some(Self { view, arm, tools: tools.into(), uses: RefCell::default() })
    }

    /// Programs move to the data or pass them on, or no program mentions them. Other data only serve computations, such
    /// as the corners of a frame and tolerances.
    pub(crate) fn is_target(&self, path: &str) -> bool {
        self.data_use(root(path)).is_target
    }

    fn data_use(&self, name: &str) -> DataUse {
        if let Some(known) = self.uses.borrow().get(name) {
            return known.clone();
        }
        let targets = targets(self.view.db, self.view.project);
        let is_mentioned = self.view.application().users.get(name).is_some_and(|users| !users.is_empty());
        let is_target = targets.contains_key(name) || !is_mentioned;
        let found = DataUse { is_target, tools: self.tools_at(name) };
        self.uses.borrow_mut().insert(name.to_owned(), found.clone());
        found
    }

    /// The value is for this kind of arm, has been taught, and no program changes it.
    pub(crate) fn is_known(&self, path: &str, position: &Position) -> bool {
        is_for(self.arm, position) && !position.is_zero() && !self.view.is_changed(path)
    }

    /// Why the arm cannot reach a point with any of the tools that may be used there; `None` if it can, or if the place
    /// of the point is not known.
    pub(crate) fn unreachable(&self, path: &str, position: &Position) -> Option<(Tool, Unreachable)> {
        let pose = constant_placement(self.view, path)?;
        let requested = position.configuration.requested();
        let mut first = None;
        for tool in self.data_use(root(path)).tools.iter() {
            match reach(self.arm, &(pose * tool.to_flange), requested) {
                Ok(_) => return None,
                Err(reason) => first = first.or_else(|| Some((tool.clone(), reason))),
            }
        }
        first
    }

    /// The tools that data may be used with: those of the moves to them if all are known, otherwise all of the project.
    fn tools_at(&self, name: &str) -> Rc<[Tool]> {
        let uses = targets(self.view.db, self.view.project).get(name).filter(|uses| !uses.is_open);
        let mut paths: Vec<&SmolStr> = uses.into_iter().flat_map(|uses| &uses.tools).collect();
        paths.sort_unstable();
        let known: Option<Vec<Tool>> = paths.into_iter().map(|path| self.tool(path)).collect();
        known.filter(|tools| !tools.is_empty()).map_or_else(|| Rc::clone(&self.tools), Rc::from)
    }

    fn tool(&self, path: &str) -> Option<Tool> {
        let known = self.tools.iter().find(|tool| tool.path.as_deref() == Some(path)).cloned();
        known.or_else(|| Some(Tool::new(None, constant_placement(self.view, path)?)))
    }

    /// The configuration in which the arm reaches a point that it does not reach in the required one.
    pub(crate) fn other_configuration(&self, path: &str, tool: &Tool) -> Option<Joints> {
        let pose = constant_placement(self.view, path)?;
        reach(self.arm, &(pose * tool.to_flange), RequestedConfiguration::FREE).ok()
    }
}

/// The type of a value does not say that it is for another kind of arm.
pub(super) fn is_for(arm: &Arm, position: &Position) -> bool {
    let kind = if arm.is_scara() { types::Arm::Scara } else { types::Arm::SixAxis };
    position.arm.is_none_or(|arm| arm == kind)
}

/// Where a value is, if no program changes it or its fathers.
fn constant_placement(view: &ProjectView<'_>, path: &str) -> Option<IsometryMatrix3<f64>> {
    let placement = placement(view.db, view.project, path).ok()?;
    let is_constant = placement.chain.iter().all(|path| !view.is_changed(path));
    is_constant.then_some(placement.pose)
}

/// The name of the data that a path starts with.
pub(super) fn root(path: &str) -> &str {
    path.split('[').next().unwrap_or(path)
}
