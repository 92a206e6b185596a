//! Properties of the types in a finding.
//!
//! Types are in the notation of the analysis: `num`, `pointRx`, `blend`. User types and containers are unknown here.

use val3_lang::{
    enumerations,
    types::{Arm, BaseType, fields},
};

use crate::english::one_of;

/// The built-in type named `ty`, and the arm that its suffix requires.
pub(crate) fn parse(ty: &str) -> Option<(BaseType, Option<Arm>)> {
    let enumeration = || enumerations::ENUMERATORS.iter().find(|row| row.ty.name() == ty);
    BaseType::from_file_name(ty).or_else(|| Some((enumeration()?.ty, None)))
}

/// Names of the type's fields, in order; `None` for a type that is not built in.
pub(crate) fn field_names(ty: &str) -> Option<Vec<&'static str>> {
    let (ty, arm) = parse(ty)?;
    Some(fields(ty, arm).iter().map(|field| field.name).collect())
}

/// Notation of a structured type's values: `{{x,y,z,rx,ry,rz},{shoulder,elbow,wrist}}`.
pub(crate) fn layout(ty: &str) -> Option<String> {
    let (ty, arm) = parse(ty)?;
    ty.is_structured().then(|| braces(ty, arm))
}

fn braces(ty: BaseType, arm: Option<Arm>) -> String {
    let parts = fields(ty, arm)
        .iter()
        .map(|field| if field.ty.is_structured() { braces(field.ty, arm) } else { field.name.to_owned() });
    format!("{{{}}}", parts.collect::<Vec<_>>().join(","))
}

/// Enumeration values, for example "`joint`, `off` or `Cartesian`"; `None` for another type.
pub(crate) fn values(ty: &str) -> Option<String> {
    let (ty, _) = parse(ty)?;
    let names: Vec<_> = enumerations::values(ty).map(|row| row.name).collect();
    (!names.is_empty()).then(|| one_of(&names))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_layout_depends_on_the_arm() {
        assert_eq!(layout("pointRx").as_deref(), Some("{{x,y,z,rx,ry,rz},{shoulder,elbow,wrist}}"));
        assert_eq!(layout("pointRs").as_deref(), Some("{{x,y,z,rx,ry,rz},{shoulder}}"));
        assert_eq!(layout("num"), None);
    }

    #[test]
    fn fields_and_enumerators_are_listed() {
        assert_eq!(field_names("frame"), Some(vec!["trsf"]));
        assert_eq!(field_names("Slot"), None);
        assert_eq!(values("blend").as_deref(), Some("`joint`, `off` or `Cartesian`"));
        assert_eq!(values("num"), None);
    }
}
