//! Constants that a program writes into motion descriptors.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_lang::types::{BaseType, fields};

use super::ProgramView;

/// A constant in a field of a motion descriptor.
pub(crate) struct DescriptorNumber<'a> {
    /// Name of the field, such as `vel`.
    pub(crate) field: &'a str,
    /// The number.
    pub(crate) value: f64,
    /// The expression.
    pub(crate) at: ExprId,
}

/// Constants that assignments write into motion descriptors, in code order.
pub(crate) fn descriptor_numbers<'a>(program: &'a ProgramView<'_>) -> Vec<DescriptorNumber<'a>> {
    let mut found = Vec::new();
    let number = |field, at: ExprId| Some(DescriptorNumber { field, value: program.body.number(at)?, at });
    for stmt in program.stmts() {
        let StmtKind::Assign { target, value } = stmt.kind else { continue };
        match (program.body.expr(target), program.body.expr(value)) {
            (Expr::Field { base, field, .. }, _) if is_descriptor(program, *base) => {
                found.extend(number(field.as_str(), value));
            }
            (_, Expr::Struct(values)) if is_descriptor(program, target) => {
                let fields = fields(BaseType::Mdesc, None).iter().zip(values);
                found.extend(fields.filter_map(|(field, value)| number(field.name, (*value)?)));
            }
            _ => {}
        }
    }
    found
}

fn is_descriptor(program: &ProgramView<'_>, id: ExprId) -> bool {
    program.inference.ty(id).base.builtin() == Some(BaseType::Mdesc)
}
