//! The last sight of a scene, for observers that evaluate each step.

use std::sync::Arc;

use crate::scene::Scene;
use crate::step::{Past, Sight, Step};

/// A scene with its last sight, at which the next step begins.
#[derive(Debug, Clone)]
pub(crate) struct Observation {
    pub(crate) scene: Arc<Scene>,
    past: Option<Past>,
}

impl Observation {
    pub(crate) fn new(scene: Arc<Scene>) -> Self {
        Self { scene, past: None }
    }

    /// Whether no sight has been recorded yet.
    pub(crate) fn is_new(&self) -> bool {
        self.past.is_none()
    }

    /// Whether nothing has moved since the last sight.
    pub(crate) fn is_same(&self, sight: &Sight<'_>) -> bool {
        self.has_arm(sight) && self.past.as_ref().is_some_and(|past| past.is_same(sight))
    }

    /// Replaces the arm model if it has changed. Returns whether earlier distances are invalid, because the links have
    /// other lengths or the arm was placed elsewhere without a motion.
    pub(crate) fn adopt(&mut self, sight: &Sight<'_>) -> bool {
        let is_other = !self.has_arm(sight);
        if is_other {
            self.scene = Arc::new(self.scene.with_arm(Arc::clone(sight.arm)));
        }
        is_other || self.past.as_ref().is_some_and(|past| past.has_jumped(sight))
    }

    /// Returns the step from the last sight to this one.
    pub(crate) fn step<'s>(&'s self, sight: &'s Sight<'_>) -> Step<'s> {
        Step::new(&self.scene, self.past.as_ref(), sight)
    }

    /// Stores a sight as the last one.
    pub(crate) fn record(&mut self, sight: &Sight<'_>) {
        self.past = Some(Past::of(sight));
    }

    fn has_arm(&self, sight: &Sight<'_>) -> bool {
        Arc::ptr_eq(&self.scene.arm, sight.arm)
    }
}
