//! The arm (9.2.3, 10.6, 11.1): its limits and the state of its motion. `devices/motion.rs` is its port.

mod joint_limits;

pub use joint_limits::JointLimits;

/// An arm that does not move: it is at joint position zero, and no move is ever recorded.
#[derive(Debug, Clone, Default)]
pub struct StandingArm {
    is_stopped: bool,
    /// Where the next move starts, if a program has said it.
    start: Option<[f64; 6]>,
    next_move: f64,
    connects_by_itself: bool,
    /// How far each axis may go.
    pub limits: JointLimits,
}

impl StandingArm {
    /// An arm of this model, with the known limits of its axes.
    #[must_use]
    pub fn new(model: &str) -> Self {
        Self { limits: JointLimits::of_model(model), ..Self::default() }
    }

    /// The position of its axes, commanded as well as measured.
    #[must_use]
    pub const fn joint(&self) -> [f64; 6] {
        [0.0; 6]
    }

    /// It stands still at the end of its last move.
    #[must_use]
    pub const fn is_settled(&self) -> bool {
        true
    }

    /// `stopMove` holds it.
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// `stopMove`.
    pub fn stop(&mut self) {
        self.is_stopped = true;
    }

    /// `restartMove`.
    pub fn restart(&mut self) {
        self.is_stopped = false;
    }

    /// `resetMotion`: the next move starts at `start`, or wherever the arm is.
    pub fn reset(&mut self, start: Option<[f64; 6]>) {
        (self.is_stopped, self.start, self.next_move) = (false, start, 0.0);
    }

    /// Where the next move starts, if a program has said it.
    #[must_use]
    pub const fn start(&self) -> Option<[f64; 6]> {
        self.start
    }

    /// The id of the next move.
    #[must_use]
    pub const fn next_move(&self) -> f64 {
        self.next_move
    }

    /// Sets the id of the next move.
    pub fn set_next_move(&mut self, id: f64) {
        self.next_move = id;
    }

    /// `autoConnectMove`: the present choice.
    #[must_use]
    pub const fn connects_by_itself(&self) -> bool {
        self.connects_by_itself
    }

    /// `autoConnectMove`: makes a choice.
    pub fn connect_by_itself(&mut self, active: bool) {
        self.connects_by_itself = active;
    }
}
