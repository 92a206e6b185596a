//! Operators: precedence and operand types.
//!
//! The manual contains one table for each type, in ascending order of precedence (3.1.2, 3.2.2, 3.4.2, 3.5.2, 3.7.2,
//! 9.2.2, 9.3.3, 9.4.3, 9.5.3, 9.6.2, 9.7.3, 10.5.2). The tables are consistent with each other and with these groups,
//! in which all operators in a group have equal precedence and are left-associative:
//!
//! ```text
//! or  <  and  <  xor  <  == !=  <  >= > <= <  <  - +  <  % / *  <  unary - !
//! ```
//!
//! `and` and `or` evaluate their right operand only if the left operand does not determine the result; `xor` evaluates
//! both.

pub mod handlers;
mod serial;

use crate::types::BaseType;

/// A binary operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    /// `or`.
    Or,
    /// `and`.
    And,
    /// `xor`.
    Xor,
    /// `==`.
    Equal,
    /// `!=`.
    NotEqual,
    /// `>=`.
    GreaterOrEqual,
    /// `>`.
    Greater,
    /// `<=`.
    LessOrEqual,
    /// `<`.
    Less,
    /// `-`.
    Subtract,
    /// `+`.
    Add,
    /// `%`; the remainder has the sign of the left operand.
    Remainder,
    /// `/`.
    Divide,
    /// `*`.
    Multiply,
}

/// A unary operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum UnaryOp {
    /// `-`.
    Negate,
    /// `!`: negation of a truth value, or inverse of a transformation.
    Not,
}

impl BinaryOp {
    /// All operators, in ascending order of precedence.
    pub const ALL: [Self; 14] = [
        Self::Or,
        Self::And,
        Self::Xor,
        Self::NotEqual,
        Self::Equal,
        Self::GreaterOrEqual,
        Self::Greater,
        Self::LessOrEqual,
        Self::Less,
        Self::Subtract,
        Self::Add,
        Self::Remainder,
        Self::Divide,
        Self::Multiply,
    ];

    /// Spelling in code.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Or => "or",
            Self::And => "and",
            Self::Xor => "xor",
            Self::Equal => "==",
            Self::NotEqual => "!=",
            Self::GreaterOrEqual => ">=",
            Self::Greater => ">",
            Self::LessOrEqual => "<=",
            Self::Less => "<",
            Self::Subtract => "-",
            Self::Add => "+",
            Self::Remainder => "%",
            Self::Divide => "/",
            Self::Multiply => "*",
        }
    }

    /// Finds an operator by its symbol; words in upper or lower case.
    #[must_use]
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|op| op.symbol().eq_ignore_ascii_case(symbol))
    }

    /// Precedence: operators with a greater number bind more tightly, operators with an equal number are
    /// left-associative.
    #[must_use]
    pub fn precedence(self) -> u8 {
        match self {
            Self::Or => 1,
            Self::And => 2,
            Self::Xor => 3,
            Self::Equal | Self::NotEqual => 4,
            Self::GreaterOrEqual | Self::Greater | Self::LessOrEqual | Self::Less => 5,
            Self::Subtract | Self::Add => 6,
            Self::Remainder | Self::Divide | Self::Multiply => 7,
        }
    }
}

impl UnaryOp {
    /// Precedence of unary operators, which bind more tightly than binary operators.
    pub const PRECEDENCE: u8 = 8;

    /// Spelling in code.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Negate => "-",
            Self::Not => "!",
        }
    }
}

/// Type of `left op right`; `None` if the operator is not defined for the two types.
#[must_use]
pub fn binary(op: BinaryOp, left: BaseType, right: BaseType) -> Option<BaseType> {
    use BaseType::{Bool, Joint, Num, String, Trsf};
    match op {
        BinaryOp::Or | BinaryOp::And | BinaryOp::Xor => (reads_as_bool(left) && reads_as_bool(right)).then_some(Bool),
        BinaryOp::Equal | BinaryOp::NotEqual => comparable(left, right).then_some(Bool),
        BinaryOp::GreaterOrEqual | BinaryOp::LessOrEqual => (left == Num && right == Num).then_some(Bool),
        BinaryOp::Greater | BinaryOp::Less => (left == right && matches!(left, Num | Joint)).then_some(Bool),
        BinaryOp::Subtract => (left == right && matches!(left, Num | Joint)).then_some(left),
        BinaryOp::Add => (left == right && matches!(left, Num | Joint | String)).then_some(left),
        BinaryOp::Remainder | BinaryOp::Divide => (left == Num && right == Num).then_some(Num),
        BinaryOp::Multiply => (left == right && matches!(left, Num | Trsf)).then_some(left),
    }
}

/// Type of both operands if they are written in braces; `None` if the operator does not determine it. Transformations
/// are the only structures that can be multiplied.
#[must_use]
pub fn structure(op: BinaryOp) -> Option<BaseType> {
    (op == BinaryOp::Multiply).then_some(BaseType::Trsf)
}

/// Type of `op operand`; `None` if the operator is not defined for the type.
#[must_use]
pub fn unary(op: UnaryOp, operand: BaseType) -> Option<BaseType> {
    match (op, operand) {
        (UnaryOp::Negate, BaseType::Num) => Some(BaseType::Num),
        (UnaryOp::Not, BaseType::Trsf) => Some(BaseType::Trsf),
        (UnaryOp::Not, operand) => reads_as_bool(operand).then_some(BaseType::Bool),
        (UnaryOp::Negate, _) => None,
    }
}

/// Whether `target = value` is valid from s7 on.
///
/// Besides equal types, a `bool` can be assigned to a digital output and a digital input to a `bool`; a `string` or a
/// `num` (one byte) can be assigned to and from a serial line. An input or output cannot be assigned to another: before
/// s7, `dio = dio` copied the state ([`Version::assigns_dio_to_dio`](crate::versions::Version::assigns_dio_to_dio)).
#[must_use]
pub fn assignment(target: BaseType, value: BaseType) -> bool {
    use BaseType::{Bool, Dio, Num, Screen, Sio, String};
    match (target, value) {
        (Dio, Bool) | (Bool, Dio) => true,
        (Sio, String | Num) | (String | Num, Sio) => true,
        (target, value) => target == value && !target.is_linkable() && target != Screen,
    }
}

/// Type of `target = value` as a value, if the assignment is valid: `dio = bool` returns the `bool` (3.5.2), `sio = string`
/// the sent `string` (3.7.2), and all other assignments return the new value of the variable.
#[must_use]
pub fn assigned(target: BaseType, value: BaseType) -> BaseType {
    match target {
        BaseType::Dio => BaseType::Bool,
        BaseType::Sio => value,
        target => target,
    }
}

/// Whether a value of this type can be a condition; the state of a digital input counts as `bool`.
#[must_use]
pub fn reads_as_bool(ty: BaseType) -> bool {
    matches!(ty, BaseType::Bool | BaseType::Dio)
}

/// Whether `==` and `!=` are defined for the two types.
#[must_use]
pub fn comparable(left: BaseType, right: BaseType) -> bool {
    if reads_as_bool(left) && reads_as_bool(right) {
        return true;
    }
    left == right && !matches!(left, BaseType::Aio | BaseType::Sio | BaseType::Screen)
}

#[cfg(test)]
mod tests {
    use super::{BinaryOp, UnaryOp, assigned, assignment, binary, structure, unary};
    use crate::types::BaseType::{Bool, Dio, Joint, Mdesc, Num, Point, Screen, Sio, String, Trsf};

    #[test]
    fn binds_as_the_tables_say() {
        let levels: Vec<u8> = BinaryOp::ALL.into_iter().map(BinaryOp::precedence).collect();
        assert!(levels.is_sorted());
        assert!(levels.into_iter().all(|level| level < UnaryOp::PRECEDENCE));
        assert!(BinaryOp::ALL.into_iter().all(|op| BinaryOp::from_symbol(op.symbol()) == Some(op)));
    }

    #[test]
    fn types_of_expressions() {
        assert_eq!(binary(BinaryOp::Add, String, String), Some(String));
        assert_eq!(binary(BinaryOp::Add, String, Num), None);
        assert_eq!(binary(BinaryOp::Multiply, Trsf, Trsf), Some(Trsf));
        assert_eq!(binary(BinaryOp::Less, Joint, Joint), Some(Bool));
        assert_eq!(binary(BinaryOp::LessOrEqual, Joint, Joint), None);
        assert_eq!(binary(BinaryOp::Equal, Dio, Bool), Some(Bool));
        assert_eq!(binary(BinaryOp::And, Dio, Bool), Some(Bool));
        assert_eq!(binary(BinaryOp::Equal, Point, Trsf), None);
        assert_eq!(binary(BinaryOp::Equal, Mdesc, Mdesc), Some(Bool));
        assert_eq!(unary(UnaryOp::Not, Dio), Some(Bool));
        assert_eq!(unary(UnaryOp::Not, Trsf), Some(Trsf));
        assert_eq!(unary(UnaryOp::Negate, Joint), None);
    }

    #[test]
    fn the_structure_between_braces_suits_its_operator() {
        let found = structure(BinaryOp::Multiply).unwrap();
        assert_eq!(binary(BinaryOp::Multiply, found, found), Some(Trsf));
        assert_eq!(structure(BinaryOp::Equal), None);
    }

    #[test]
    fn assignments() {
        assert!(assignment(Dio, Bool) && assignment(Bool, Dio));
        assert!(assignment(Sio, String) && assignment(Num, Sio));
        assert!(assignment(Point, Point));
        assert!(!assignment(Dio, Dio) && !assignment(Screen, Screen) && !assignment(Num, Bool));
    }

    /// The result types that 3.1.2, 3.2.2, 3.4.2, 3.5.2, 3.7.2 and 9.6.2 print.
    #[test]
    fn results_of_assignments() {
        for (target, value, result) in [
            (Bool, Bool, Bool),
            (Num, Num, Num),
            (String, String, String),
            (Dio, Bool, Bool),
            (Bool, Dio, Bool),
            (Sio, String, String),
            (Sio, Num, Num),
            (Num, Sio, Num),
            (String, Sio, String),
            (Point, Point, Point),
        ] {
            assert!(assignment(target, value));
            assert_eq!(assigned(target, value), result, "{target:?} = {value:?}");
        }
    }
}
