//! An application's arm, and the positions that it can reach.

use std::cell::RefCell;
use std::fmt::Display;
use std::rc::Rc;
use std::sync::Arc;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::arm::{ProjectArm, arm};
use val3_analysis::db::{Db, Project};
use val3_analysis::items::positions::{TaughtPosition, positions};
use val3_analysis::items::project::data_files;
use val3_analysis::placement::{joints, placement};
use val3_analysis::reach::{reach, without_same};
use val3_analysis::targets::targets;
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints, RequestedConfiguration, Unreachable};
use val3_lang::data_path::DataPath;
use val3_lang::types::{self, BaseType};

use super::ProjectView;

/// A tool with its centre point's pose on the flange.
#[derive(Debug, Clone)]
pub(crate) struct FlangeTool {
    /// Data path; `None` for the flange.
    pub(crate) path: Option<String>,
    /// Pose of the flange, relative to the centre point.
    to_flange: IsometryMatrix3<f64>,
}

impl FlangeTool {
    fn new(path: Option<String>, pose: IsometryMatrix3<f64>) -> Self {
        Self { path, to_flange: pose.inverse() }
    }
}

/// Arm of a project; `None` if the configured arm cannot be used.
pub(crate) fn of_project(db: &dyn Db, project: Project) -> Option<&ProjectArm> {
    arm(db, project).as_ref().ok()
}

/// Describes an axis range; axes count from 1.
pub(crate) fn range(arm: &Arm, axis: usize, [min, max]: [f64; 2]) -> String {
    format!("{min} to {max} {}", arm.unit(axis.saturating_sub(1)))
}

/// Formats the position of an axis (from 1), with the unit of a length, which data files may contain in inches.
pub(crate) fn position(arm: &Arm, axis: usize, position: impl Display) -> String {
    if arm.is_stroke(axis.saturating_sub(1)) { format!("{position} mm") } else { position.to_string() }
}

/// Reachability of positions in data files.
pub(crate) struct ArmReach<'a> {
    view: &'a ProjectView<'a>,
    pub(crate) arm: &'a Arc<Arm>,
    /// The flange, and every tool of the project whose data no program changes.
    tools: Rc<[FlangeTool]>,
    /// Cached uses of data by name, which are equal for all elements of a container.
    uses: RefCell<FxHashMap<String, DataUse>>,
}

/// Uses of data as move targets.
#[derive(Debug, Clone)]
struct DataUse {
    is_target: bool,
    tools: Rc<[FlangeTool]>,
}

impl<'a> ArmReach<'a> {
    pub(crate) fn new(view: &'a ProjectView<'a>) -> Option<Self> {
        let arm = &of_project(view.db, view.project)?.model;
        let mut tools = vec![FlangeTool::new(None, IsometryMatrix3::identity())];
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
                .filter_map(|path| Some(FlangeTool::new(Some(path.to_string()), constant_placement(view, path)?))),
        );
        Some(Self { view, arm, tools: tools.into(), uses: RefCell::default() })
    }

    /// Whether moves may use the data as a target: a move or a call does, or no program mentions them. Other data are
    /// only operands, for example frame corners or tolerances.
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

    /// Whether the value suits this kind of arm, has been taught, and no program changes it.
    pub(crate) fn is_known(&self, path: &str, position: &TaughtPosition) -> bool {
        is_for(self.arm, position) && !position.is_zero() && !self.view.is_changed(path)
    }

    /// Reason why the arm cannot reach a point with any of the tools that may be used there; `None` if it can, or if
    /// the placement of the point is unknown.
    pub(crate) fn unreachable(&self, path: &str, position: &TaughtPosition) -> Option<(FlangeTool, Unreachable)> {
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

    /// Joint positions in which the arm may be at a position of the data files, with their tools: for a point, all
    /// configurations that it allows, with each tool that may be used there. `None` if its placement is unknown.
    pub(crate) fn possible_joints(
        &self,
        path: &str,
        position: &TaughtPosition,
    ) -> Option<Vec<(Option<FlangeTool>, Joints)>> {
        match position.ty {
            BaseType::Joint => Some(vec![(None, joints(self.view.db, self.view.project, position, self.arm))]),
            BaseType::Point => {
                let pose = constant_placement(self.view, path)?;
                let tools = self.data_use(root(path)).tools;
                let all = tools.iter().flat_map(|tool| {
                    let solutions = solutions(self.arm, &(pose * tool.to_flange), position.configuration.requested());
                    solutions.into_iter().map(|joints| (Some(tool.clone()), joints))
                });
                Some(all.collect())
            }
            _ => None,
        }
    }

    /// Tools with which data may be used: the tools of the moves to them if all are known, otherwise all tools of the
    /// project.
    fn tools_at(&self, name: &str) -> Rc<[FlangeTool]> {
        let uses = targets(self.view.db, self.view.project).get(name).filter(|uses| !uses.is_open);
        let mut paths: Vec<&SmolStr> = uses.into_iter().flat_map(|uses| &uses.tools).collect();
        paths.sort_unstable();
        let known: Option<Vec<FlangeTool>> = paths.into_iter().map(|path| self.tool(path)).collect();
        known.filter(|tools| !tools.is_empty()).map_or_else(|| Rc::clone(&self.tools), Rc::from)
    }

    fn tool(&self, path: &str) -> Option<FlangeTool> {
        let known = self.tools.iter().find(|tool| tool.path.as_deref() == Some(path)).cloned();
        known.or_else(|| Some(FlangeTool::new(None, constant_placement(self.view, path)?)))
    }

    /// Another configuration with which the arm reaches a point that it does not reach in the required configuration.
    pub(crate) fn other_configuration(&self, path: &str, tool: &FlangeTool) -> Option<Joints> {
        let pose = constant_placement(self.view, path)?;
        reach(self.arm, &(pose * tool.to_flange), RequestedConfiguration::FREE).ok()
    }
}

/// Whether a value of this type suits the arm (six-axis or SCARA). Types that name no kind suit both.
pub(super) fn is_for(arm: &Arm, position: &TaughtPosition) -> bool {
    let kind = if arm.is_scara() { types::Arm::Scara } else { types::Arm::SixAxis };
    position.arm.is_none_or(|arm| arm == kind)
}

/// Joint positions for a flange pose and the requested configurations, each axis within one turn.
pub(super) fn solutions(arm: &Arm, flange: &IsometryMatrix3<f64>, requested: RequestedConfiguration) -> Vec<Joints> {
    let requested = without_same(requested);
    let mut solutions: Vec<Joints> = arm.solutions(flange, &[0.0; 6]).collect();
    solutions.retain(|joints| {
        let configuration = arm.configuration(joints);
        requested.allows(configuration, configuration)
    });
    solutions
}

/// Placement of a value, if no program changes it or its fathers.
pub(super) fn constant_placement(view: &ProjectView<'_>, path: &str) -> Option<IsometryMatrix3<f64>> {
    let placement = placement(view.db, view.project, path).ok()?;
    let is_constant = placement.chain.iter().all(|path| !view.is_changed(path));
    is_constant.then_some(placement.pose)
}

/// The name of the data that a path starts with.
pub(super) fn root(path: &str) -> &str {
    DataPath::new(path).before_index()
}
