//! Makes a program or data public or private.

use smol_str::SmolStr;
use val3_analysis::db::{Db, Project};
use val3_analysis::interfaces::{implements, is_public, is_same_item};
use val3_analysis::items::{data, program};
use val3_analysis::occurrences::Symbol;
use val3_analysis::xml::XmlElement;
use val3_syntax::SyntaxKind;
use val3_syntax::view::View;

use super::context::Context;
use super::{AssistKind, Assists};
use crate::access;
use crate::edit::SourceChange;
use crate::navigate::{implemented, implementing};
use crate::owner::projects_of;
use crate::references::uses;

const ID: &str = "toggle-access";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let parse = val3_analysis::items::parse(context.db, context.file);
    let view = parse.view();
    let element = declaring(context, view)?;
    let public = access::is_public(element);
    let title = if public { "Make private" } else { "Make public" };
    if let Some(reason) = obstacle(context, element, public) {
        assists.refuse(None, ID, AssistKind::Rewrite, title, reason);
        return None;
    }
    assists.add(ID, AssistKind::Rewrite, title, || {
        let (range, text) = access::set(context.text, element, !public)?;
        let edit = context.replace(range, text);
        Some(SourceChange::of([edit]))
    });
    Some(())
}

/// Reason why the access cannot be changed, in a project that contains the file; `None` if it can.
fn obstacle(context: &Context<'_>, element: XmlElement<'_>, public: bool) -> Option<String> {
    let name = SmolStr::from(element.value("name")?);
    let db = context.db;
    let mut projects = projects_of(db, context.file).iter().copied();
    if !public {
        return projects.find_map(|project| against_interface(db, project, &name));
    }
    let item = ToggledItem { name, is_program: matches!(element.name(), "Program" | "program") };
    projects.find_map(|project| used_elsewhere(db, project, &item))
}

/// Program or data with the name whose access changes.
struct ToggledItem {
    name: SmolStr,
    is_program: bool,
}

impl ToggledItem {
    fn symbol(&self, project: Project) -> Symbol {
        match self.is_program {
            true => Symbol::Program(project, self.name.clone()),
            false => Symbol::Data(project, self.name.clone()),
        }
    }

    /// Name of a project that uses the item of `owner`, other than `owner` and `project`.
    fn user<'db>(&self, db: &'db dyn Db, owner: Project, project: Project) -> Option<&'db str> {
        let symbol = self.symbol(owner);
        let (_, user, _) = uses(db, &symbol).find(|(_, user, _)| *user != owner && *user != project)?;
        Some(stem(db, user))
    }
}

/// Reports another project that uses the item directly, or through an interface for which this project is loaded.
fn used_elsewhere(db: &dyn Db, project: Project, item: &ToggledItem) -> Option<String> {
    let name = &item.name;
    if let Some(user) = item.user(db, project, project) {
        return Some(format!("`{user}` uses `{name}`"));
    }
    implemented(db, project).find_map(|interface| {
        let user = item.user(db, interface, project)?;
        Some(format!(
            "`{user}` uses `{name}` of the interface `{}`, which this library is loaded for",
            stem(db, interface)
        ))
    })
}

/// Reports an interface or library that the public item would contradict: the interface of this library, or a library
/// that is loaded for this interface.
fn against_interface(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    if let Some(interface) = implemented(db, project).find(|interface| differs(db, *interface, project, name)) {
        return Some(format!("the interface `{}` declares `{name}` differently", stem(db, interface)));
    }
    let lacking = implementing(db, project).find(|library| !implements(db, project, *library, name))?;
    Some(format!("`{}` is loaded for this interface and has no matching public `{name}`", stem(db, lacking)))
}

/// Whether the interface has a public item of this name that differs from the item of `project`.
fn differs(db: &dyn Db, interface: Project, project: Project, name: &str) -> bool {
    is_public(db, interface, name) && is_same_item(db, interface, project, name) == Some(false)
}

/// Project name, which is its file name.
fn stem(db: &dyn Db, project: Project) -> &str {
    project.manifest(db).path(db).file_stem().unwrap_or("")
}

/// Program whose header contains the range, or data whose start tag contains it.
fn declaring<'g>(context: &Context<'_>, view: View<'g>) -> Option<XmlElement<'g>> {
    let at = context.range;
    let touches = |element: &XmlElement<'_>| element.tag_range().contains_range(at);
    let program = program::element(view).filter(|program| touches(program) || is_at_begin(context));
    program.or_else(|| data::elements(view).find(touches))
}

/// Whether the cursor is on the `begin` of the code, which represents the header if the header is folded or hidden.
pub(super) fn is_at_begin(context: &Context<'_>) -> bool {
    context.range.is_empty() && context.token().is_some_and(|token| token.kind() == SyntaxKind::BEGIN_KW)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::ID;
    use crate::assists::testing::{check, offered, refused};

    fn program(attributes: &str) -> String {
        format!(
            "num nA\n=== main/other.pgx\n<Programs><Program name=\"other\"{attributes}><Code><![CDATA[beg$0in\n  put(1)\nend]]></Code></Program></Programs>\n"
        )
    }

    #[test]
    fn the_access_of_a_program_is_changed() {
        check(
            ID,
            &program(""),
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other"><Code><![CDATA[begin
            +<Programs><Program name="other" access="public"><Code><![CDATA[begin
        "#]],
        );
        check(
            ID,
            &program(" access=\"public\""),
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other" access="public"><Code><![CDATA[begin
            +<Programs><Program name="other"><Code><![CDATA[begin
        "#]],
        );
        check(
            ID,
            &program(" access=\"public\" "),
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other" access="public" ><Code><![CDATA[begin
            +<Programs><Program name="other" access="private" ><Code><![CDATA[begin
        "#]],
        );
        check(
            ID,
            &program("").replace("$0", "").replace("name=", "na$0me="),
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other"><Code><![CDATA[begin
            +<Programs><Program name="other" access="public"><Code><![CDATA[begin
        "#]],
        );
        assert_eq!(offered("program other()\nbegin\n  pu$0t(1)\nend", ID), None);
    }

    const DATA: &str = "num nZ\n=== main/main.dtx\n<Database xmlns:xsi=\"i\"><Datas><Data name=\"n$0A\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" /></Datas></Database>\n";

    #[test]
    fn the_access_of_data_is_changed() {
        check(
            ID,
            DATA,
            expect![[r#"
            usrapp/main/main.dtx
            -<Database xmlns:xsi="i"><Datas><Data name="nA" access="private" xsi:type="array" type="num" size="1" /></Datas></Database>
            +<Database xmlns:xsi="i"><Datas><Data name="nA" access="public" xsi:type="array" type="num" size="1" /></Datas></Database>
        "#]],
        );
        check(
            ID,
            "num nZ\n=== main/main.dtx\n<dataList><numSection><num name=\"n$0A\" public=\"true\"></num></numSection></dataList>\n",
            expect![[r#"
                usrapp/main/main.dtx
                -<dataList><numSection><num name="nA" public="true"></num></numSection></dataList>
                +<dataList><numSection><num name="nA" public="false"></num></numSection></dataList>
            "#]],
        );
    }

    const LOADER: &str = "library part \"Disk://part/part.pjx\" autoload=false\nnum nA\n\
        nA=part:libLoad(\"Disk://box\")\npart:nWeight=1\ncall part:pick(1)\n";

    #[test]
    fn items_used_by_other_projects_stay_public() {
        for (library, reason) in [
            ("--- part\n=== part/part.dtx\n@\n--- box", "`main` uses `nWeight`"),
            (
                "--- part\npublic num nWeight\n--- box\n=== box/box.dtx\n@",
                "`main` uses `nWeight` of the interface `part`, which this library is loaded for",
            ),
            (
                "--- part\n=== part/pick.pgx\n<Programs><Program na$0me=\"pick\" access=\"public\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>",
                "`main` uses `pick`",
            ),
            (
                "--- part\n=== part/part.dtx\n<dataList><numSection><num name=\"nWei$0ght\" public=\"true\" /></numSection></dataList>",
                "`main` uses `nWeight`",
            ),
        ] {
            let data = "<Database><Datas><Data name=\"nWei$0ght\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"1\" /></Datas></Database>";
            let listing = format!("{LOADER}{}", library.replace('@', data));
            assert_eq!(refused(&listing, ID).as_deref(), Some(reason), "{listing}");
        }
    }

    #[test]
    fn fields_of_user_types_stay_public() {
        let listing = "type Slot \"Disk://Slot/Slot.pjx\"\nprivate Slot sA\nsA.nHeight=1\n--- Slot\n=== Slot/Slot.dtx\n\
            <Database><Datas><Data name=\"nHei$0ght\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"1\" /></Datas></Database>";
        assert_eq!(refused(listing, ID).as_deref(), Some("`main` uses `nHeight`"));
    }

    #[test]
    fn items_used_in_their_own_project_can_become_private() {
        let listing = "nA=1\n=== main/main.dtx\n<Database><Datas><Data name=\"n$0A\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"1\" /></Datas></Database>";
        assert_eq!((offered(listing, ID).as_deref(), refused(listing, ID)), (Some("Make private"), None));
    }

    #[test]
    fn the_access_must_suit_interfaces_and_their_libraries() {
        let library = |ty| format!("{LOADER}--- part\npublic num nWeight\n--- box\n=== box/box.dtx\n{}", private(ty));
        assert_eq!(
            refused(&library("string"), ID).as_deref(),
            Some("the interface `part` declares `nWeight` differently")
        );
        assert_eq!(offered(&library("num"), ID).as_deref(), Some("Make public"));
        let own = private("num");
        let interface = |other| format!("{LOADER}--- box\n{other}\n--- part\n=== part/part.dtx\n{own}");
        assert_eq!(
            refused(&interface("num nWeight"), ID).as_deref(),
            Some("`box` is loaded for this interface and has no matching public `nWeight`")
        );
        assert_eq!(offered(&interface("public num nWeight[3]"), ID).as_deref(), Some("Make public"));
    }

    /// A data file with the private data `nWeight`.
    fn private(ty: &str) -> String {
        format!(
            "<Database><Datas><Data name=\"nWei$0ght\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"1\" /></Datas></Database>"
        )
    }
}
