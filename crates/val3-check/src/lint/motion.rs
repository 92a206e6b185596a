//! State of the arm while the program runs ahead of it.

use std::cell::OnceCell;
use std::rc::Rc;

use rustc_hash::FxHashMap;
use val3_analysis::body::ExprId;
use val3_analysis::flow::{Facts, FlowNode, FlowNodeId, PointKind, forward};
use val3_lang::instruction::Overload;
use val3_lang::motion::{self, MotionRole};

use super::choices::{Choice, enumerated};
use super::{Call, Choices, ProgramView};

/// Certain facts about the arm and its moves before each flow node of a program.
pub(crate) struct MotionFacts {
    arm: Facts<ArmState>,
    /// Computed on demand.
    choices: OnceCell<Facts<Rc<Choices>>>,
    /// Flow nodes of the calls that record moves.
    moves: FxHashMap<ExprId, FlowNodeId>,
}

/// Certain facts about the arm, on every path to a flow node.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ArmState {
    /// Call that recorded the last move.
    pub(crate) last: Option<ExprId>,
    /// Corner at the end of that move.
    pub(crate) corner: MoveCorner,
    /// Activity of the arm.
    pub(crate) phase: ArmActivity,
}

/// Corner at the end of the last recorded move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum MoveCorner {
    /// Nothing is certain.
    #[default]
    Unknown,
    /// The next move determines it.
    Open,
    /// The arm stops there.
    Stop,
}

/// Activity of the arm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum ArmActivity {
    /// Nothing is certain.
    #[default]
    Unknown,
    /// A move was recorded, and the program has not waited since then.
    Moving,
    /// The arm is stopped, and nothing has restarted it.
    Stopped {
        /// Call that stopped it.
        by: ExprId,
        /// Whether a recorded move is certainly not finished.
        pending: bool,
    },
}

impl ArmActivity {
    /// Facts that hold on both joining paths.
    fn join(self, other: Self) -> Self {
        match (self, other) {
            (Self::Stopped { by, pending }, Self::Stopped { by: other, pending: also }) if by == other => {
                Self::Stopped { by, pending: pending && also }
            }
            _ if self == other => self,
            _ => Self::Unknown,
        }
    }

    /// Whether a recorded move is certainly not finished.
    fn has_pending_move(self) -> bool {
        matches!(self, Self::Moving | Self::Stopped { pending: true, .. })
    }
}

/// A call that concerns the arm, and the certain facts before it.
pub(crate) struct ArmCall<'db> {
    pub(crate) call: Call<'db>,
    pub(crate) role: MotionRole,
    pub(crate) arm: ArmState,
}

impl MotionFacts {
    fn new(program: &ProgramView<'_>) -> Self {
        let step = |id: FlowNodeId, point: &FlowNode, before: &ArmState| program.arm_after(id, point, *before);
        let arm = forward(program.flow(), ArmState::default(), step, ArmState::join);
        let mut moves = FxHashMap::default();
        for (id, _) in program.flow().points() {
            let calls = program.calls_at(id).iter().filter(|call| is_move(call));
            moves.extend(calls.map(|call| (call.id, id)));
        }
        Self { arm, choices: OnceCell::new(), moves }
    }

    /// Flow node of the call that records a move.
    pub(crate) fn point_of(&self, call: ExprId) -> Option<FlowNodeId> {
        self.moves.get(&call).copied()
    }

    /// Certain facts about the arm before a flow node.
    pub(crate) fn arm(&self, point: FlowNodeId) -> ArmState {
        self.arm.before(point).copied().unwrap_or_default()
    }
}

impl ArmState {
    /// Keeps the facts that hold on both paths.
    fn join(&mut self, other: &Self) -> bool {
        let before = *self;
        if self.last != other.last {
            self.last = None;
        }
        if self.corner != other.corner {
            self.corner = MoveCorner::Unknown;
        }
        self.phase = self.phase.join(other.phase);
        *self != before
    }

    fn after(self, call: &Call<'_>) -> Self {
        let Some(role) = call.role else {
            return if call.instruction.blocking { Self { phase: ArmActivity::Unknown, ..self } } else { self };
        };
        let stopped_by = if let ArmActivity::Stopped { by, .. } = self.phase { Some(by) } else { None };
        let phase = match (role, stopped_by) {
            (MotionRole::Reset, _) => return Self::default(),
            (MotionRole::Move(_), Some(by)) => ArmActivity::Stopped { by, pending: true },
            (MotionRole::Move(_), None) => ArmActivity::Moving,
            (MotionRole::Stop, _) => ArmActivity::Stopped { by: call.id, pending: self.phase.has_pending_move() },
            // A program that reads the progress may have found that every move is finished.
            (MotionRole::Progress, Some(by)) => ArmActivity::Stopped { by, pending: false },
            (MotionRole::Position, _) => self.phase,
            (MotionRole::Arrive | MotionRole::Restart | MotionRole::Progress, _) => ArmActivity::Unknown,
        };
        let (last, corner) = match role {
            MotionRole::Move(_) => (Some(call.id), MoveCorner::Open),
            MotionRole::Arrive => (self.last, MoveCorner::Stop),
            _ => (self.last, self.corner),
        };
        Self { last, corner, phase }
    }
}

fn is_move(call: &Call<'_>) -> bool {
    matches!(call.role, Some(MotionRole::Move(_)))
}

impl<'db> ProgramView<'db> {
    /// Target of the move that `call` records.
    pub(crate) fn target(&self, call: ExprId) -> Option<ExprId> {
        self.move_argument(call, motion::target)
    }

    /// Motion descriptor of the move that `call` records.
    pub(crate) fn descriptor(&self, call: ExprId) -> Option<ExprId> {
        self.move_argument(call, motion::descriptor)
    }

    fn move_argument(&self, call: ExprId, position: fn(&Overload) -> Option<usize>) -> Option<ExprId> {
        let call = self.call_of(call)?;
        call.args.get(position(call.form?)?).copied()
    }

    /// Whether the move that `call` records has a rounded corner: its descriptor certainly sets a blend, and not by
    /// default.
    pub(crate) fn is_blended(&self, call: ExprId) -> bool {
        let descriptor = self.descriptor(call);
        let choices = descriptor.map(|id| self.choices_of(call, id)).unwrap_or_default();
        choices.iter().any(|choice| choice.is_chosen && motion::is_blend(choice.value))
    }

    /// Certain values of the enumerated fields of the variable `argument` at the move that `call` records.
    pub(crate) fn choices_of(&self, call: ExprId, argument: ExprId) -> Vec<Choice> {
        let known = self.motion().and_then(|motion| {
            let choices = motion.choices.get_or_init(|| self.choices());
            choices.before(motion.point_of(call)?)
        });
        let ty = self.inference.ty(argument).base.builtin();
        let (Some(known), Some(ty)) = (known, ty) else { return Vec::new() };
        enumerated(ty).filter_map(|(field, _)| self.choice(known, argument, field)).collect()
    }

    /// Certain facts about the arm; `None` for a program that does not use it.
    pub(crate) fn motion(&self) -> Option<&MotionFacts> {
        let new = || self.calls().iter().any(|call| call.role.is_some()).then(|| MotionFacts::new(self));
        self.motion.get_or_init(new).as_ref()
    }

    /// All calls that concern the arm, with the certain facts before each. Unreachable flow nodes are omitted.
    pub(crate) fn arm_calls(&self) -> &[ArmCall<'db>] {
        self.arm_calls.get_or_init(|| self.find_arm_calls())
    }

    fn find_arm_calls(&self) -> Vec<ArmCall<'db>> {
        let Some(motion) = self.motion() else { return Vec::new() };
        let mut steps = Vec::new();
        for (id, _) in self.flow().points() {
            let Some(mut arm) = motion.arm.before(id).copied() else { continue };
            for call in self.calls_at(id) {
                steps.extend(call.role.map(|role| ArmCall { call: *call, role, arm }));
                arm = arm.after(call);
            }
        }
        steps
    }

    fn arm_after(&self, id: FlowNodeId, point: &FlowNode, before: ArmState) -> ArmState {
        let after = self.calls_at(id).iter().fold(before, |arm, call| arm.after(call));
        // The effect of the called program on the arm is unknown here.
        if matches!(point.kind, PointKind::Call(_)) { ArmState::default() } else { after }
    }
}
