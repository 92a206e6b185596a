//! One-line statements: assignments, motion, screen, inputs and outputs.

use super::body::Body;
use super::model::Type;
use super::shared::SIGNALS;

/// Types of assigned variables with their frequency.
const ASSIGNED: &[(usize, Type)] = &[
    (50, Type::Num),
    (20, Type::Bool),
    (15, Type::Text),
    (6, Type::Point),
    (4, Type::Trsf),
    (3, Type::Joint),
    (2, Type::Slot),
];

type LineGenerator = for<'a, 'b> fn(&'a mut Body<'b>) -> String;

impl Body<'_> {
    /// Generates `a=b`, occasionally `a=b=c`.
    pub(super) fn assignment(&mut self) {
        if self.random.chance(6) {
            return self.output();
        }
        let ty = self.random.weighted(ASSIGNED).unwrap_or(Type::Num);
        let target = self.target(ty);
        let value = Some(self.expression(ty)).filter(|value| *value != target);
        let Some(value) = value else { return self.output() };
        let equals = if self.random.chance(14) { " = " } else { "=" };
        if ty == Type::Num && self.random.chance(1) {
            let second = self.target(ty);
            return self.line(format!("{target}{equals}{second}{equals}{value}"));
        }
        self.line(format!("{target}{equals}{value}"));
    }

    /// Returns a variable to assign to. Every application has data of every type.
    fn target(&mut self, ty: Type) -> String {
        let place = self.scope.writable(ty, self.random).unwrap_or_default();
        self.note(place)
    }

    fn output(&mut self) {
        let signal = self.random.below(SIGNALS);
        let value = self.random.word(&["true", "false"]);
        self.line("waitEndMove()");
        self.line(format!("io:dOut[{signal}]={value}"));
    }

    /// Generates an instruction on a separate line.
    pub(super) fn instruction(&mut self) {
        const LINES: &[(usize, LineGenerator)] = &[
            (22, |body| body.joint_move()),
            (16, |body| body.linear_move()),
            (2, |body| body.circular_move()),
            (14, |_| "waitEndMove()".to_owned()),
            (3, |_| "resetMotion()".to_owned()),
            (10, |body| format!("delay({})", body.random.word(&["0", "0.1", "0.5", "1"]))),
            (16, |body| format!("putln({})", body.expression(Type::Text))),
            (6, |body| format!("put({})", body.expression(Type::Num))),
            (4, |body| format!("gotoxy({},{})", body.random.below(40), body.random.below(14))),
            (4, |_| "cls()".to_owned()),
            (3, |body| format!("title ({})", body.expression(Type::Text))),
            (6, |body| format!("logMsg({})", body.expression(Type::Text))),
            (4, |body| format!("popUpMsg({})", body.expression(Type::Text))),
            (7, |body| format!("wait({})", body.expression(Type::Bool))),
            (5, |body| format!("watch({},{})", body.expression(Type::Bool), body.random.between(1, 20))),
            (4, |body| format!("open({})", body.read(Type::Tool))),
            (4, |body| format!("close({})", body.read(Type::Tool))),
            (2, |body| format!("setMonitorSpeed({})", body.random.between(1, 100))),
        ];
        if let Some(line) = self.random.weighted(LINES) {
            let line = line(self);
            self.line(line);
        }
    }

    fn joint_move(&mut self) -> String {
        let target = if self.random.chance(60) { Type::Joint } else { Type::Point };
        let target = self.expression(target);
        format!("movej({target},{},{})", self.read(Type::Tool), self.read(Type::Mdesc))
    }

    fn linear_move(&mut self) -> String {
        let target = self.expression(Type::Point);
        format!("movel({target},{},{})", self.read(Type::Tool), self.read(Type::Mdesc))
    }

    fn circular_move(&mut self) -> String {
        let (through, target) = (self.expression(Type::Point), self.expression(Type::Point));
        format!("movec({through},{target},{},{})", self.read(Type::Tool), self.read(Type::Mdesc))
    }
}
