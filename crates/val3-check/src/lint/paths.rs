//! Checks moves between positions that are known from the data files.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::body::{Expr, ExprId};
use val3_analysis::changes::is_changed;
use val3_analysis::effects::RootVariable;
use val3_analysis::items::manifest::length_unit;
use val3_analysis::placement::{joints, placement, position, transformation};
use val3_analysis::reach::reach;
use val3_analysis::targets::path;
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, ConfigurationRequest, Joints, RequestedConfiguration};
use val3_lang::motion::{self, MotionRole, RequestedPath, keeps_configuration, moves_along_own_axes};
use val3_lang::types::BaseType;
use val3_motion::{Cause, Millimetres, MovePath, MoveTarget, blend_fault};

use super::motion::{ArmCall, ArmState, MoveCorner};
use super::nominal::{end_of, nominal_move};
use super::planned_moves::{ImpossibleMove, PlannedMove, PlannedMoves, PossibleWay, UnreachablePath};
use super::reachability::{is_for, of_project, root, solutions};
use super::{Call, ProgramView};

/// A position that is constant while the application runs.
#[derive(Clone)]
enum Known {
    Joints(Joints),
    Point(KnownPose),
}

#[derive(Clone)]
struct KnownPose {
    /// Pose in `world`.
    pose: IsometryMatrix3<f64>,
    configuration: RequestedConfiguration,
    /// Whether the program computes it from data.
    is_computed: bool,
}

fn plan(program: &ProgramView<'_>) -> PlannedMoves {
    let calls = program.arm_calls();
    let Some(arm) = of_project(program.db, program.project).filter(|_| !calls.is_empty()) else {
        return PlannedMoves::default();
    };
    let mut check = PathCheck { program, arm: &arm.model, moves: FxHashMap::default(), found: Vec::new() };
    calls.iter().for_each(|call| check.call(call));
    let mut moves: Vec<(ExprId, PlannedMove)> = check.moves.into_iter().collect();
    moves.sort_unstable_by_key(|(call, _)| *call);
    PlannedMoves { impossible: check.found, moves }
}

struct PathCheck<'p, 'db> {
    program: &'p ProgramView<'db>,
    arm: &'p Arc<Arm>,
    moves: FxHashMap<ExprId, PlannedMove>,
    found: Vec<ImpossibleMove>,
}

impl PathCheck<'_, '_> {
    fn call(&mut self, step: &ArmCall<'_>) {
        let (MotionRole::Move(path), call) = (step.role, &step.call) else { return };
        let Some((known, tool)) = self.target(call) else { return };
        let before = step.arm.last.and_then(|last| Some((last, self.start(last)?)));
        let joint = |start: &Joints, end: Joints| PossibleWay { start: *start, path: MovePath::Joint(end), end };
        let ways: Vec<PossibleWay> = match (path, &known, &before) {
            (RequestedPath::Cartesian, Known::Point(target), Some((last, starts))) => {
                self.along_path(call, *last, starts, target, &tool).unwrap_or_default()
            }
            (RequestedPath::Joint, Known::Point(target), Some((_, starts))) => {
                let flange = Trsf::from(target.pose * tool.inverse());
                let solve = |start: &Joints| self.arm.solve(&flange, start, target.configuration).ok();
                starts.iter().filter_map(|start| Some(joint(start, solve(start)?))).collect()
            }
            (RequestedPath::Joint, Known::Joints(joints), Some((_, starts))) => {
                starts.iter().map(|start| joint(start, *joints)).collect()
            }
            _ => Vec::new(),
        };
        let ends = match known {
            Known::Joints(joints) => vec![joints],
            Known::Point(_) => ways.iter().map(|way| way.end).collect(),
        };
        if ends.is_empty() {
            self.unreachable(call);
            return;
        }
        let last = before.map(|(last, _)| last);
        let planned = PlannedMove { ends, ways, tool, last, reach: self.reach_before(step.arm) };
        if let (Some(last), MoveCorner::Open) = (step.arm.last, step.arm.corner) {
            self.corner(last, call.id, &planned);
        }
        self.moves.insert(call.id, planned);
    }

    /// Reach distance in mm of the blend before the next move, 0 if the arm stops there; `None` if it is uncertain.
    fn reach_before(&self, arm: ArmState) -> Option<f64> {
        match arm.corner {
            MoveCorner::Unknown => None,
            MoveCorner::Stop => Some(0.0),
            MoveCorner::Open => Some(self.program.blend(arm.last?)?.distances().map_or(0.0, |(_, reach)| reach)),
        }
    }

    /// Reports the corner between two moves if the arm cannot follow its blend on any way.
    fn corner(&mut self, last: ExprId, next: ExprId, to: &PlannedMove) {
        let Some(cause) = self.corner_fault(last, next, to) else { return };
        if let (Some(target), from) = (self.program.target(next), self.program.target(last)) {
            self.found.push(ImpossibleMove { target, from, shape: UnreachablePath::Blend, cause });
        }
    }

    fn corner_fault(&self, last: ExprId, next: ExprId, to: &PlannedMove) -> Option<Cause> {
        let from = self.moves.get(&last)?;
        let (blend, next_blend, reach) = (self.program.blend(last)?, self.program.blend(next)?, from.reach?);
        let mut found = None;
        for first in &from.ways {
            let first_move = nominal_move(self.arm, &first.path, &from.tool, blend);
            for second in to.ways.iter().filter(|second| second.start == first.end) {
                let moves = [&first_move, &nominal_move(self.arm, &second.path, &to.tool, next_blend)];
                match blend_fault(self.arm, first.start, moves, Millimetres(reach)) {
                    Ok(Some(cause)) => found = found.or(Some(cause)),
                    Ok(None) => return None,
                    // Another finding reports the move.
                    Err(_) => {}
                }
            }
        }
        found
    }

    /// Possible joint positions at the end of the move `last`; `None` if unknown.
    fn start(&self, last: ExprId) -> Option<Vec<Joints>> {
        if let Some(planned) = self.moves.get(&last) {
            return Some(planned.ends.clone());
        }
        let call = self.program.call_of(last)?;
        let starts = match self.target(call)? {
            (Known::Joints(joints), _) => vec![joints],
            (Known::Point(target), tool) => self.positions_of(&target, &tool),
        };
        (!starts.is_empty()).then_some(starts)
    }

    /// All joint positions for a target, in all turns of the axes.
    fn positions_of(&self, target: &KnownPose, tool: &IsometryMatrix3<f64>) -> Vec<Joints> {
        let flange = target.pose * tool.inverse();
        let mut found = solutions(self.arm, &flange, target.configuration);
        for axis in (0..self.arm.axes()).filter(|axis| !self.arm.is_stroke(*axis)) {
            let turned = found.iter().flat_map(|joints| [-360.0, 360.0].map(|turn| turned(joints, axis, turn)));
            let turned: Vec<Joints> = turned.filter(|joints| self.arm.is_in_range(joints)).collect();
            found.extend(turned);
        }
        found
    }

    /// Ways along a line or circle. Reports the move if no start permits it.
    fn along_path(
        &mut self,
        call: &Call<'_>,
        last: ExprId,
        starts: &[Joints],
        target: &KnownPose,
        tool: &IsometryMatrix3<f64>,
    ) -> Option<Vec<PossibleWay>> {
        let flange = target.pose * tool.inverse();
        // Another rule reports a point that the arm cannot reach.
        reach(self.arm, &flange, target.configuration).ok()?;
        let destination = MoveTarget { pose: target.pose, configuration: target.configuration };
        let through = self.intermediate(call)?;
        let shape = if through.is_some() { UnreachablePath::Circle } else { UnreachablePath::Line };
        let path = match through {
            Some(through) => MovePath::Circle(through, destination),
            None => MovePath::Line(destination),
        };
        let mut cause = None;
        let mut ways = Vec::new();
        for start in starts {
            match end_of(self.arm, *start, &path, tool) {
                Ok(end) => ways.push(PossibleWay { start: *start, path: path.clone(), end }),
                Err(other) => cause = cause.or(Some(other)),
            }
        }
        if let Some(cause) = cause.filter(|cause| ways.is_empty() && !self.is_obvious(cause, last, target)) {
            let (Some(to), from) = (self.program.target(call.id), self.program.target(last)) else { return None };
            self.found.push(ImpossibleMove { target: to, from, shape, cause });
        }
        Some(ways)
    }

    /// Whether both targets request different configurations explicitly, which is reported for every arm (V0405).
    fn is_obvious(&self, cause: &Cause, last: ExprId, target: &KnownPose) -> bool {
        let before = self.program.call_of(last).and_then(|call| self.target(call));
        let (Cause::Configuration, Some((Known::Point(before), _))) = (cause, before) else { return false };
        fn differ<T: PartialEq>(one: &ConfigurationRequest<T>, other: &ConfigurationRequest<T>) -> bool {
            matches!((one, other), (ConfigurationRequest::Exactly(one), ConfigurationRequest::Exactly(other)) if one != other)
        }
        let (from, to) = (before.configuration, target.configuration);
        differ(&from.shoulder, &to.shoulder) || differ(&from.elbow, &to.elbow) || differ(&from.wrist, &to.wrist)
    }

    /// Reports a move to a computed point that the arm cannot reach. Another rule reports points of the data.
    fn unreachable(&mut self, call: &Call<'_>) {
        let Some((Known::Point(target), tool)) = self.target(call) else { return };
        if !target.is_computed {
            return;
        }
        let reached = reach(self.arm, &(target.pose * tool.inverse()), target.configuration);
        if let (Err(cause), Some(to)) = (reached, self.program.target(call.id)) {
            self.found.push(ImpossibleMove {
                target: to,
                from: None,
                shape: UnreachablePath::Line,
                cause: cause.into(),
            });
        }
    }

    fn target(&self, call: &Call<'_>) -> Option<(Known, IsometryMatrix3<f64>)> {
        let form = call.form?;
        let known = self.program.known(self.program.target(call.id)?)?;
        let tool = match motion::tool(form).and_then(|at| call.args.get(at)) {
            Some(tool) => self.program.known_placement(*tool)?,
            None => IsometryMatrix3::identity(),
        };
        Some((known, tool))
    }

    /// Intermediate point of a circle, `Some(None)` for a line, `None` if unknown.
    fn intermediate(&self, call: &Call<'_>) -> Option<Option<IsometryMatrix3<f64>>> {
        let params = call.form?.params;
        let mut points = params.iter().zip(call.args).filter(|(param, _)| param.ty == Some(BaseType::Point));
        match (points.next(), points.next()) {
            (Some((_, through)), Some(_)) => match self.program.known(*through)? {
                Known::Point(target) => Some(Some(target.pose)),
                Known::Joints(_) => None,
            },
            _ => Some(None),
        }
    }
}

fn turned(joints: &Joints, axis: usize, turn: f64) -> Joints {
    let mut turned = *joints;
    turned.iter_mut().skip(axis).take(1).for_each(|joint| *joint += turn);
    turned
}

impl ProgramView<'_> {
    /// Moves between known positions, computed on demand.
    pub(crate) fn planned_moves(&self) -> &PlannedMoves {
        self.planned_moves.get_or_init(|| plan(self))
    }

    /// An expression's constant position.
    fn known(&self, id: ExprId) -> Option<Known> {
        let id = self.body.without_parentheses(id);
        if let Some(call) = self.call_of(id) {
            return self.known_near(call).map(Known::Point);
        }
        let path = self.constant_path(id)?;
        let arm = &of_project(self.db, self.project)?.model;
        let value = position(self.db, self.project, &path).filter(|value| is_for(arm, value))?;
        match value.ty {
            BaseType::Joint => Some(Known::Joints(joints(self.db, self.project, value, arm))),
            BaseType::Point if !value.is_zero() => Some(Known::Point(KnownPose {
                pose: self.constant_placement(&path)?,
                configuration: value.configuration.requested(),
                is_computed: false,
            })),
            _ => None,
        }
    }

    /// Point near another point that a call returns.
    fn known_near(&self, call: &Call<'_>) -> Option<KnownPose> {
        let (true, true, [point, by]) =
            (keeps_configuration(call.instruction), moves_along_own_axes(call.instruction), call.args)
        else {
            return None;
        };
        let (Known::Point(near), by) = (self.known(*point)?, self.known_trsf(*by)?) else { return None };
        Some(KnownPose { pose: near.pose * by.isometry(), is_computed: true, ..near })
    }

    /// A transformation in mm: a literal of numbers, or data that no program changes.
    fn known_trsf(&self, id: ExprId) -> Option<Trsf> {
        let id = self.body.without_parentheses(id);
        let trsf = match self.body.expr(id) {
            Expr::Struct(fields) => {
                let numbers: Option<Vec<f64>> =
                    fields.iter().map(|field| field.map_or(Some(0.0), |field| self.body.number(field))).collect();
                let &[x, y, z, rx, ry, rz] = numbers?.as_slice() else { return None };
                Trsf::new([x, y, z], [rx, ry, rz])
            }
            _ => transformation(
                position(self.db, self.project, &self.constant_path(id)?).filter(|value| value.ty == BaseType::Trsf)?,
            ),
        };
        Some(trsf.scaled(length_unit(self.db, self.project.manifest(self.db)).millimetres()))
    }

    /// Constant placement of a frame, tool or point in the data, or of a built-in.
    fn known_placement(&self, id: ExprId) -> Option<IsometryMatrix3<f64>> {
        let id = self.body.without_parentheses(id);
        match self.effects.root(id) {
            None => self.constant_placement(&path(self.body, id)?),
            Some(_) => self.constant_placement(&self.constant_path(id)?),
        }
    }

    fn constant_placement(&self, path: &str) -> Option<IsometryMatrix3<f64>> {
        let placement = placement(self.db, self.project, path).ok()?;
        placement.chain.iter().all(|path| self.is_constant_path(path)).then_some(placement.pose)
    }

    /// Data path that no program changes.
    pub(super) fn constant_path(&self, id: ExprId) -> Option<SmolStr> {
        let Some(RootVariable::Data(_)) = self.effects.root(id) else { return None };
        path(self.body, id).filter(|path| self.is_constant_path(path))
    }

    /// Whether the value is constant: the application has no faults, and no program in this or another application
    /// changes it.
    fn is_constant_path(&self, path: &str) -> bool {
        self.is_closed(root(path)) && !is_changed(self.db, self.project, path)
    }
}
