//! Name prefixes, for the rules about them.

use smol_str::SmolStr;
use val3_analysis::db::Db;
use val3_analysis::ty::Base;
use val3_config::Options;

use crate::diagnostic::Wording;
use crate::english::a;

/// Type name in code, without an arm suffix.
pub(crate) fn type_name(db: &dyn Db, base: Base) -> SmolStr {
    match base {
        Base::Builtin(base, _) => base.name().into(),
        other => other.display(db),
    }
}

/// Wording for a `what` with this type whose name does not begin with the configured prefix: the letters for `scope`
/// and for the type.
pub(crate) fn check_name(options: &Options, what: &str, ty: &str, scope: &str, name: &str) -> Option<Wording> {
    let letters = options.prefixes.get(ty)?;
    let prefix = format!("{scope}{letters}");
    (!begins(name, &prefix)).then(|| {
        Wording::new(
            format!("the name of the {what} `{name}` does not begin with `{prefix}`"),
            format!("this is {}", a(ty)),
            format!("call it `{prefix}{}`", capitalised(bare(options, name))),
        )
    })
}

/// Whether the name begins with the prefix, and the rest is a separate word: `nCount` and `n2` begin with `n`, `number`
/// does not. The names `n` and `l_n` are short forms and also count.
fn begins(name: &str, prefix: &str) -> bool {
    name.strip_prefix(prefix).is_some_and(|rest| !rest.starts_with(|first: char| first.is_ascii_lowercase()))
        // Inputs and outputs often have further letters: `diDoor`, `doLamp`, `aiWeight`.
        || name.strip_prefix(prefix).is_some_and(|rest| {
            let mut letters = rest.chars();
            matches!(letters.next(), Some('i' | 'o')) && letters.next().is_some_and(|next| next.is_ascii_uppercase())
        })
}

/// Name without the letters of any scope and type.
fn bare<'n>(options: &Options, name: &'n str) -> &'n str {
    let scopes = [&options.local_prefix, &options.parameter_prefix];
    let scope = scopes.into_iter().filter(|scope| !scope.is_empty());
    let name = scope.filter_map(|scope| name.strip_prefix(scope.as_str())).next().unwrap_or(name);
    let rest = options.prefixes.values().filter_map(|letters| name.strip_prefix(letters.as_str()));
    let words = rest.filter(|rest| rest.starts_with(|first: char| first.is_ascii_uppercase()));
    words.min_by_key(|word| word.len()).unwrap_or(name)
}

fn capitalised(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map(|first| first.to_ascii_uppercase().to_string() + letters.as_str()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::begins;

    #[test]
    fn a_prefix_ends_before_a_word() {
        for name in ["nCount", "n", "n2", "n_a"] {
            assert!(begins(name, "n"), "{name}");
        }
        for name in ["number", "N", "xCount", "niece"] {
            assert!(!begins(name, "n"), "{name}");
        }
        assert!(begins("l_nA", "l_n") && begins("doLamp", "d") && !begins("door", "d"));
    }
}
