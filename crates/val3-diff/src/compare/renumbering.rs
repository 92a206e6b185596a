//! Renumbering of arrays: removed or inserted elements shift the index of the elements after them.

use rustc_hash::FxHashMap;
use smol_str::{SmolStr, format_smolstr};
use val3_analysis::items::data::DataDecl;
use val3_lang::types::{BaseType, Container, attributes};
use val3_syntax::TextSlice;

use super::alignment::{AlignmentStep, align};
use super::movement;
use super::placement::Places;
use super::values::{Contents, key};
use crate::model::{MovedElements, Renumbering};
use crate::read::data::DataVersion;

/// Maximum ratio of the highest index to the number of written elements for which an array is aligned. A file with a
/// few lines may contain an element with index 4,000,000,000.
const SPARSEST: usize = 4;

/// An array with removed or inserted elements.
#[derive(Debug)]
pub(super) struct Renumbered {
    /// Old data with the new indexes, without the removed elements.
    pub(super) old: DataVersion,
    /// New data without the inserted elements.
    pub(super) new: DataVersion,
    /// Old indexes of removed elements.
    pub(super) removed: Vec<usize>,
    /// New indexes of inserted elements.
    pub(super) inserted: Vec<usize>,
    pub(super) renumbering: Renumbering,
}

/// Finds removed and inserted elements; `None` if a comparison by index has fewer differences, or if the index
/// identifies the elements.
pub(super) fn find(old: &DataVersion, new: &DataVersion, places: &mut Places<'_>) -> Option<Renumbered> {
    if !can_be_renumbered(old, new) {
        return None;
    }
    let mut ids = Ids::default();
    let (old_ids, new_ids) = (ids.of(old)?, ids.of(new)?);
    let steps = align(&old_ids, &new_ids);
    let differing: Vec<usize> = differing_indexes(&old_ids, &new_ids, ids.unwritten()).collect();
    let (changes, kept): (Vec<_>, Vec<_>) = steps.iter().partition(|step| is_change(**step, &old_ids, &new_ids));
    if !kept.into_iter().any(is_move) || changes.len() >= differing.len() {
        return None;
    }
    let greatest_distance_mm = greatest_distance(&new.decl.name, &differing, places);
    let renumbering = Renumbering { runs: runs(&steps), differing_indexes: differing.len(), greatest_distance_mm };
    let removed = steps
        .iter()
        .filter_map(|step| if let AlignmentStep::Removed(old) = step { Some(*old) } else { None })
        .collect();
    let inserted: Vec<usize> = steps
        .iter()
        .filter_map(|step| if let AlignmentStep::Inserted(new) = step { Some(*new) } else { None })
        .collect();
    let pairs = pairs(&steps);
    set_origins(new, &pairs, places);
    Some(Renumbered {
        old: under_new_indexes(old, new, &pairs),
        new: without(new, &inserted),
        removed,
        inserted,
        renumbering,
    })
}

/// Whether the step removes or inserts an element, or pairs elements with different contents.
fn is_change(step: AlignmentStep, old_ids: &[u32], new_ids: &[u32]) -> bool {
    match step {
        AlignmentStep::Pair { old, new } => old_ids.get(old) != new_ids.get(new),
        AlignmentStep::Removed(_) | AlignmentStep::Inserted(_) => true,
    }
}

fn is_move(step: &AlignmentStep) -> bool {
    matches!(step, AlignmentStep::Pair { old, new } if old != new)
}

/// Whether elements may be matched with another index. Frames and tools are excluded, because fathers refer to them by
/// index. Single numbers do not identify an element, so in arrays of them elements are matched only if the size
/// differs.
fn can_be_renumbered(old: &DataVersion, new: &DataVersion) -> bool {
    let is_rich = new.base.is_none_or(|(ty, arm)| attributes(ty, arm).len() > 1);
    let has_other_size = old.decl.sizes != new.decl.sizes;
    [old, new].into_iter().all(|data| is_array(data) && !has_fathers(data)) && (is_rich || has_other_size)
}

fn is_array(data: &DataVersion) -> bool {
    data.decl.container != Container::Collection && data.decl.sizes.len() == 1
}

/// Whether the data contain frames or tools, which can be fathers of other data.
fn has_fathers(data: &DataVersion) -> bool {
    data.values.iter().any(|(_, value)| matches!(value.ty, BaseType::Frame | BaseType::Tool))
}

/// Identifiers of the different element contents.
#[derive(Debug, Default)]
struct Ids(FxHashMap<Vec<String>, u32>);

impl Ids {
    /// Returns the identifiers of the elements up to the last written element; `None` for a sparse array.
    fn of(&mut self, data: &DataVersion) -> Option<Vec<u32>> {
        let contents = Contents::of(data);
        let indexes = data.keys.iter().filter(|key| data.has_element(key)).filter_map(|key| key.parse::<usize>().ok());
        let length = indexes.max().map_or(0, |last| last + 1);
        if length > data.keys.len() * SPARSEST {
            return None;
        }
        let mut sizes: FxHashMap<&str, Vec<String>> = FxHashMap::default();
        for (path, size) in &data.field_sizes {
            let key = key(&data.decl.name, path);
            let field = path.part(data.decl.name.len() + key.len() + 2..);
            sizes.entry(key).or_default().push(format!("{field} {size}"));
        }
        let mut ids = Vec::with_capacity(length);
        for key in (0..length).map(|index| index.to_string()) {
            let mut texts = contents.get(&key).map_or_else(Vec::new, <[String]>::to_vec);
            texts.extend(sizes.remove(key.as_str()).unwrap_or_default());
            ids.push(self.id(texts));
        }
        Some(ids)
    }

    fn id(&mut self, texts: Vec<String>) -> u32 {
        let next = u32::try_from(self.0.len()).unwrap_or(u32::MAX);
        *self.0.entry(texts).or_insert(next)
    }

    /// Returns the identifier of the default content, which all elements after the last written one have.
    fn unwritten(&mut self) -> u32 {
        self.id(Vec::new())
    }
}

fn differing_indexes<'i>(old: &'i [u32], new: &'i [u32], unwritten: u32) -> impl Iterator<Item = usize> + 'i {
    let get = move |ids: &[u32], index: usize| ids.get(index).copied().unwrap_or(unwritten);
    (0..old.len().max(new.len())).filter(move |index| get(old, *index) != get(new, *index))
}

fn greatest_distance(name: &str, indexes: &[usize], places: &mut Places<'_>) -> Option<f64> {
    let paths = indexes.iter().map(|index| format!("{name}[{index}]"));
    let displacements = paths.filter_map(|path| movement::in_world(&path, &path, places));
    displacements.map(|displacement| displacement.distance_mm).reduce(f64::max)
}

/// Returns the new index of every old index that is in both versions.
fn pairs(steps: &[AlignmentStep]) -> FxHashMap<usize, usize> {
    let mut indexes = FxHashMap::default();
    for step in steps {
        if let AlignmentStep::Pair { old, new } = *step {
            indexes.insert(old, new);
        }
    }
    indexes
}

/// Returns the runs of elements whose index differs.
fn runs(steps: &[AlignmentStep]) -> Vec<MovedElements> {
    let mut runs: Vec<MovedElements> = Vec::new();
    for step in steps {
        let AlignmentStep::Pair { old, new } = *step else { continue };
        match runs.last_mut().filter(|run| run.old + run.count == old && run.new + run.count == new) {
            Some(run) => run.count += 1,
            None => runs.push(MovedElements { old, new, count: 1 }),
        }
    }
    runs.retain(|run| run.old != run.new);
    runs
}

/// Returns the path of the same value in the renumbered element; `None` if the element is not in both versions.
fn moved(name: &str, path: &str, pairs: &FxHashMap<usize, usize>) -> Option<SmolStr> {
    let key = key(name, path);
    let index = pairs.get(&key.parse().ok()?)?;
    let rest = path.get(name.len() + key.len() + 2..)?;
    Some(format_smolstr!("{name}[{index}]{rest}"))
}

fn under_new_indexes(old: &DataVersion, new: &DataVersion, pairs: &FxHashMap<usize, usize>) -> DataVersion {
    let name = &old.decl.name;
    let key = |key: &SmolStr| pairs.get(&key.parse().ok()?).map(|index| format_smolstr!("{index}"));
    let values = old.values.iter().filter_map(|(path, value)| Some((moved(name, path, pairs)?, value.clone())));
    let sizes = old.field_sizes.iter().filter_map(|(path, size)| Some((moved(name, path, pairs)?, size.clone())));
    DataVersion {
        decl: DataDecl { sizes: new.decl.sizes.clone(), ..old.decl.clone() },
        base: old.base,
        keys: old.keys.iter().filter_map(key).collect(),
        values: values.collect(),
        field_sizes: sizes.collect(),
    }
}

fn without(data: &DataVersion, inserted: &[usize]) -> DataVersion {
    let mut rest = data.clone();
    let name = &data.decl.name;
    rest.values.retain(|(path, _)| !is_index_in(inserted, key(name, path)));
    rest.field_sizes.retain(|path, _| !is_index_in(inserted, key(name, path)));
    rest
}

/// Whether the key is an index in the sorted `indexes`.
fn is_index_in(indexes: &[usize], key: &str) -> bool {
    key.parse().is_ok_and(|index: usize| indexes.binary_search(&index).is_ok())
}

fn set_origins(new: &DataVersion, pairs: &FxHashMap<usize, usize>, places: &mut Places<'_>) {
    let old_indexes: FxHashMap<usize, usize> = pairs.iter().map(|(old, new)| (*new, *old)).collect();
    for (path, _) in &new.values {
        places.set_origin(path.clone(), moved(&new.decl.name, path, &old_indexes));
    }
}
