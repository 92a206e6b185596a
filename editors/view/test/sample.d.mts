// The types of the sample.
export const HOSTILE: string;
export const PHASES: readonly string[];
export function scene(role?: string): object;
export function messages(role?: string): (object | Buffer)[];
export function recording(list?: (object | Buffer)[]): string;
export function exported(page?: string): string;
