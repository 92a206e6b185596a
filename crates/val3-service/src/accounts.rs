//! Accounts: the profiles with which clients log in.

use constant_time_eq::constant_time_eq;
use val3_machine::controller_state::Profile;
use val3_session::{CellProfile, ProfileRights};

/// Profiles of a controller, with passwords and rights.
#[derive(Debug, Clone, Default)]
pub struct Accounts(Vec<Account>);

/// Profile with which clients log in.
#[derive(Debug, Clone)]
struct Account {
    name: String,
    /// Password; `None` if only the cell describes the profile, whose password is obscured: any password is accepted.
    password: Option<String>,
    rights: ProfileRights,
}

impl Accounts {
    /// Creates accounts for the profiles in the controller's settings and in the cell's files. Passwords come from the
    /// settings, rights from the cell. A profile without a file in the cell has all rights.
    #[must_use]
    pub fn new(profiles: &[Profile], of_cell: Vec<CellProfile>) -> Self {
        let own = |name: &str| profiles.iter().find(|profile| profile.name.eq_ignore_ascii_case(name));
        let mut accounts: Vec<Account> = of_cell
            .into_iter()
            .map(|CellProfile { name, rights }| {
                let password = own(&name).map(|profile| profile.password.clone()).filter(|text| !text.is_empty());
                Account { password, name, rights }
            })
            .collect();
        for Profile { name, password, .. } in profiles {
            if accounts.iter().all(|account| !account.name.eq_ignore_ascii_case(name)) {
                let (name, password) = (name.clone(), Some(password.clone()));
                accounts.push(Account { name, password, rights: ProfileRights::ALL });
            }
        }
        Self(accounts)
    }

    /// Names of the profiles for which any password is accepted.
    pub fn without_password_check(&self) -> impl Iterator<Item = &str> {
        self.0.iter().filter(|account| account.password.is_none()).map(|account| account.name.as_str())
    }

    /// Rights of a user; `None` if the profile does not exist or the password is wrong.
    pub(crate) fn rights(&self, user: &str, password: &str) -> Option<ProfileRights> {
        let account = self.0.iter().find(|account| account.name.eq_ignore_ascii_case(user))?;
        let expected = account.password.as_deref();
        let is_right = expected.is_none_or(|expected| constant_time_eq(expected.as_bytes(), password.as_bytes()));
        is_right.then_some(account.rights)
    }
}
