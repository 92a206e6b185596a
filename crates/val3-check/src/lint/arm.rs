//! The arm of an application, and the positions that it can reach.

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
    pub(crate) pose: IsometryMatrix3<f64>,
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
    tools: Vec<Tool>,
}

impl<'a> Reach<'a> {
    pub(crate) fn new(view: &'a ProjectView<'a>) -> Option<Self> {
        let arm = &of_project(view.db, view.project)?.model;
        let mut tools = vec![Tool { path: None, pose: IsometryMatrix3::identity() }];
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
                .filter_map(|path| Some(Tool { path: Some(path.to_string()), pose: constant_placement(view, path)? })),
        );
        Some(Self { view, arm, tools })
    }

    /// Programs move to the data or pass them on, or no program mentions them. Other data only serve computations, such
    /// as the corners of a frame and tolerances.
    pub(crate) fn is_target(&self, path: &str) -> bool {
        let name = root(path);
        let uses = self.view.application().users.get(name);
        targets(self.view.db, self.view.project).contains_key(name) || uses.is_none_or(Vec::is_empty)
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
        for tool in self.tools_at(path) {
            match reach(self.arm, &(pose * tool.pose.inverse()), requested) {
                Ok(_) => return None,
                Err(reason) => first = first.or(Some((tool, reason))),
            }
        }
        first
    }

    /// The tools that a point may be used with: those of the moves to it if all are known, otherwise all of the project.
    fn tools_at(&self, path: &str) -> Vec<Tool> {
        let uses = targets(self.view.db, self.view.project).get(root(path));
        let Some(uses) = uses.filter(|uses| !uses.is_open) else { return self.tools.clone() };
        let mut names: Vec<_> = uses.tools.iter().collect();
        names.sort_unstable();
        let known = |path: &&smol_str::SmolStr| {
            self.tools
                .iter()
                .find(|tool| tool.path.as_deref() == Some(path.as_str()))
                .cloned()
                .or_else(|| constant_placement(self.view, path).map(|pose| Tool { path: None, pose }))
        };
        let known: Option<Vec<_>> = names.iter().map(known).collect();
        known.filter(|tools| !tools.is_empty()).unwrap_or_else(|| self.tools.clone())
    }

    /// The configuration in which the arm reaches a point that it does not reach in the required one.
    pub(crate) fn other_configuration(&self, path: &str, tool: &Tool) -> Option<Joints> {
        let pose = constant_placement(self.view, path)?;
        reach(self.arm, &(pose * tool.pose.inverse()), RequestedConfiguration::FREE).ok()
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
