// Fields of a table. Typed text is applied with Enter or when the field loses the focus; Escape reverts it.

import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

interface FieldProps {
  /** Column, for the focus. */
  field: string;
  label: string;
  value: string;
  /** Identifier of the message at the row, if it is about this field. */
  fault?: string | undefined;
  onCommit: (value: string) => Promise<boolean>;
  onRevert: () => void;
}

export function TextField({ field, label, value, fault, onCommit, onRevert }: FieldProps): JSX.Element {
  const [draft, setDraft] = useState<string | undefined>(undefined);
  const sent = useRef<string | undefined>(undefined);
  useEffect(() => {
    setDraft(undefined);
    sent.current = undefined;
  }, [value]);
  const commit = async (): Promise<void> => {
    if (draft === undefined || draft === value || draft === sent.current) {
      return;
    }
    sent.current = draft;
    if (await onCommit(draft)) {
      setDraft(undefined);
      sent.current = undefined;
    }
  };
  const revert = (): void => {
    setDraft(undefined);
    sent.current = undefined;
    onRevert();
  };
  return (
    <input
      type="text"
      spellcheck={false}
      data-field={field}
      aria-label={label}
      aria-invalid={fault !== undefined}
      aria-describedby={fault}
      value={draft ?? value}
      onInput={({ currentTarget }) => setDraft(currentTarget.value)}
      onBlur={() => void commit()}
      onKeyDown={({ key }) => (key === "Enter" ? void commit() : key === "Escape" ? revert() : undefined)}
    />
  );
}

interface ChoiceProps extends FieldProps {
  choices: readonly string[];
}

export function ChoiceField({ field, label, value, choices, fault, onCommit }: ChoiceProps): JSX.Element {
  const all = choices.includes(value) ? choices : [value, ...choices];
  const element = useRef<HTMLSelectElement>(null);
  const commit = async (chosen: string): Promise<void> => {
    if (!(await onCommit(chosen)) && element.current !== null) {
      element.current.value = value;
    }
  };
  return (
    <select
      ref={element}
      data-field={field}
      aria-label={label}
      aria-invalid={fault !== undefined}
      aria-describedby={fault}
      value={value}
      onChange={({ currentTarget }) => void commit(currentTarget.value)}
    >
      {all.map((choice) => <option key={choice} value={choice}>{choice}</option>)}
    </select>
  );
}
