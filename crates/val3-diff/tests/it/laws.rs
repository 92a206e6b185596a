//! Properties of comparisons that always hold.

use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use val3_diff::format::{html, human, json, markdown};
use val3_diff::model::{ApplicationChange, Change};
use val3_diff::report::Detail;
use val3_diff::{Comparison, FileTree, compare};

fn data_element((name, (ty, public, values)): (String, (u8, bool, Vec<i8>))) -> String {
    let access = if public { "public" } else { "private" };
    let (ty, attribute, rest) =
        [("num", "value", ""), ("pointRx", "x", "fatherId=\"a[0]\""), ("frame", "rz", "fatherId=\"b[0]\"")]
            [usize::from(ty)];
    let size = values.len();
    let value = |(key, value): (usize, &i8)| format!("<Value key=\"{key}\" {attribute}=\"{value}\" {rest}/>");
    let values: String = values.iter().enumerate().map(value).collect();
    format!(
        "<Data name=\"{name}\" access=\"{access}\" xsi:type=\"array\" type=\"{ty}\" size=\"{size}\">{values}</Data>"
    )
}

/// Generates data with a few names, so that both trees have common data.
fn data() -> impl Strategy<Value = String> {
    let declaration = (0..3_u8, prop::bool::ANY, vec(-5..5_i8, 1..4));
    btree_map("[a-e]", declaration, 0..5).prop_map(|all| {
        let all: String = all.into_iter().map(data_element).collect();
        format!("<Database><Datas>{all}</Datas></Database>")
    })
}

fn program() -> impl Strategy<Value = String> {
    vec("(a=1|b=2|// c|  if a|endIf|<x|)", 0..8).prop_map(|lines| {
        let code = lines.join("\n");
        format!("<Programs><Program name=\"p\"><Code><![CDATA[begin\n{code}\nend]]></Code></Program></Programs>")
    })
}

fn tree() -> impl Strategy<Value = FileTree> {
    let project = "<Project><Programs><Program file=\"p.pgx\"/></Programs></Project>";
    let text = prop_oneof![8 => data().boxed(), 8 => program().boxed(), 1 => "\\PC{0,20}".boxed()];
    btree_map("(a|b)/(a.dtx|p.pgx|q.pgx)", text, 0..5).prop_map(move |files| {
        let with_project = files.into_iter().chain([("a/a.pjx".to_owned(), project.to_owned())]);
        FileTree::new(with_project)
    })
}

fn add_changes(application: &ApplicationChange, add: &mut dyn FnMut(Change)) {
    add(application.change);
    application.programs.iter().for_each(|program| add(program.change));
    application.texts.iter().for_each(|text| add(text.change));
    for data in &application.data {
        add(data.change);
        data.values.iter().for_each(|value| add(value.change));
    }
}

/// Returns the number of added, removed and changed items.
fn counts(comparison: &Comparison) -> [usize; 3] {
    let mut counts = [0; 3];
    let mut add = |change: Change| counts[change as usize] += 1;
    comparison.applications.iter().for_each(|application| add_changes(application, &mut add));
    counts
}

proptest! {
    #[test]
    fn nothing_differs_from_itself(tree in tree()) {
        let found = compare(&tree, &tree);
        prop_assert!(found.is_empty() && found.problems.is_empty(), "{found:?}");
    }

    #[test]
    fn every_comparison_can_be_shown(old in tree(), new in tree()) {
        let found = compare(&old, &new);
        let page = html::write(&found, Detail::Full);
        prop_assert_eq!(page.matches("<ul>").count(), page.matches("</ul>").count());
        prop_assert!(serde_json::from_str::<serde_json::Value>(&json::write(&found, Detail::Full).unwrap()).is_ok());
        prop_assert!(markdown::write(&found, Detail::Full).starts_with("# "));
        prop_assert!(!human::lines(&found, Detail::Full).is_empty());
    }

    #[test]
    fn the_other_way_round_added_is_removed(old in tree(), new in tree()) {
        let [added, removed, changed] = counts(&compare(&old, &new));
        prop_assert_eq!(counts(&compare(&new, &old)), [removed, added, changed]);
    }
}
