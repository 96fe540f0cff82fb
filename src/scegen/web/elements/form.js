// The functional scenario as a form, drawn from the description of its fields that the server sends.
const EMPTY = (value) => value === null || value === undefined || (Array.isArray(value) && !value.length);
const copy = (value) => JSON.parse(JSON.stringify(value ?? null));
const plain = (word) => String(word).replaceAll("_", " ");

// What a new item holds: its defaults, and the first word or name where one is needed.
const fresh = (fields, names) => {
  const made = {};
  for (const f of fields) {
    if (!f.required) made[f.name] = copy(f.default);
    else if (f.type === "word") made[f.name] = f.words[0].value;
    else if (f.type === "words") made[f.name] = [f.words[0].value];
    else if (f.type === "name") made[f.name] = (names[f.of] || [])[0] ?? "";
    else if (f.type === "names") made[f.name] = (names[f.of] || []).slice(0, 2);
    else if (f.type === "interval") made[f.name] = { low: 1, high: 1 };
    else if (f.type === "number") made[f.name] = f.min ?? 0;
    else made[f.name] = f.type === "list" ? [] : "";
  }
  return made;
};

const Field = {
  name: "Field",
  template: `
    <div class="field" :class="['f-' + f.type, { unsaid: standing && standing.standing !== 'understood', error: wrong }]"
      @mouseenter="point(path)" @mouseleave="point(null)">
      <span class="field-label" :data-tip="f.means">{{ f.label }}
        <button v-if="standing" class="dot" :class="standing.standing" :data-tip="standing.standing + tail"
          :aria-label="f.label + ': ' + standing.standing + (standing.standing === 'assumed' ? ', confirm' : '')"
          :disabled="standing.standing === 'understood'" @click="ctx.confirm(path)"></button>
      </span>
      <span class="field-value">
        <input v-if="f.type === 'id'" class="name" :value="value" maxlength="40" :size="Math.max(4, String(value).length)"
          spellcheck="false" autocomplete="off" :aria-label="'Name of ' + value" data-tip="Its name; a new one takes its place everywhere"
          @change="rename($event.target)" @keydown.enter.prevent="$event.target.blur()">
        <button v-else-if="f.type === 'flag'" class="tag" :class="{ on: value }" :aria-pressed="!!value"
          @click="set(!value)">{{ value ? 'yes' : 'no' }}</button>
        <select v-else-if="f.type === 'word'" :value="value ?? ''" :aria-label="f.label" :data-tip="meaning(value)"
          @change="set($event.target.value || null)">
          <option v-if="f.optional" value="">–</option>
          <option v-for="w in f.words" :key="w.value" :value="w.value" :title="w.means">{{ plain(w.value) }}</option>
        </select>
        <span v-else-if="f.type === 'words' || f.type === 'names' || f.type === 'numbers'" class="tags">
          <button v-for="w in offered" :key="w.value" class="tag" :class="{ on: has(w.value) }" :data-tip="w.means"
            :aria-pressed="has(w.value)" @click="toggle(w.value)">{{ f.type === 'words' ? plain(w.value) : w.value }}</button>
          <button v-if="hidden" class="tag more" @click="open = !open">{{ open ? 'less' : EMPTY(value) ? 'free' : '+' }}</button>
        </span>
        <select v-else-if="f.type === 'name'" :value="value ?? ''" :aria-label="f.label"
          @change="set($event.target.value || null)">
          <option v-if="f.optional" value="">–</option>
          <option v-for="n in ctx.names[f.of] || []" :key="n" :value="n">{{ n }}</option>
        </select>
        <span v-else-if="f.type === 'interval'" class="interval">
          <input type="number" step="any" :value="shown(value && value.low)" :placeholder="f.optional ? 'free' : ''"
            :aria-label="ranged ? f.label + ', lowest' : f.label" @change="bound('low', $event.target.value)">
          <template v-if="ranged"><span class="dash">–</span>
            <input type="number" step="any" :value="shown(value && value.high)"
              :aria-label="f.label + ', highest'" @change="bound('high', $event.target.value)"></template>
          <span class="unit">{{ f.unit }}</span>
          <button v-if="value && !ranged" class="tag more" data-tip="Give a range instead of one value"
            :aria-label="f.label + ': give a range'" @click="open = true">…</button>
        </span>
        <span v-else-if="f.type === 'number'" class="interval">
          <input type="number" :step="f.whole ? 1 : 'any'" :min="f.min" :max="f.factor === 1 ? f.max : undefined"
            :value="shown(value)" :placeholder="f.optional ? 'free' : ''" :aria-label="f.label"
            @change="set(read($event.target.value))"><span class="unit">{{ f.unit }}</span>
        </span>
        <input v-else-if="f.type === 'sequence'" :value="(value || []).map(shown).join(', ')" placeholder="the usual"
          :aria-label="f.label" @change="sequence($event.target.value)">
        <span v-else-if="f.type === 'choice'" class="tags">
          <select :value="value ? value.type : ''" :aria-label="f.label" @change="member($event.target.value)">
            <option v-if="f.optional" value="">–</option>
            <option v-for="m in f.members" :key="m.tag" :value="m.tag" :title="m.means">{{ m.label }}</option>
          </select>
          <Field v-for="g in chosen ? chosen.fields : []" :key="g.name" :f="g" :value="value[g.name]"
            :path="path + '.' + g.name" :ctx="ctx" @set="(v) => set({ ...value, [g.name]: v })"></Field>
        </span>
        <input v-else :value="value ?? ''" :aria-label="f.label" @change="set($event.target.value || null)">
      </span>
    </div>`,
  props: ["f", "value", "path", "ctx"],
  emits: ["set"],
  data: () => ({ open: false }),
  computed: {
    standing() {
      // what is said of a hazard as a whole is shown at its kind
      const whole = this.f.name === "kind" ? this.ctx.standings[this.path.slice(0, -5)] : null;
      return this.ctx.standings[this.path] || whole;
    },
    tail() {
      const s = this.standing;
      const why = s.why ? ": " + s.why : "";
      return s.standing === "assumed" || s.standing === "inferred" ? why + " — click to confirm" : why;
    },
    wrong() {
      return this.ctx.wrong && this.ctx.wrong.startsWith(this.path + ":");
    },
    all() {
      if (this.f.type === "words") return this.f.words;
      const names = this.f.type === "names" ? this.ctx.names[this.f.of] || [] : [...Array(this.ctx.arms).keys()];
      return names.map((value) => ({ value, means: "" }));
    },
    hidden() {
      return this.f.type === "words" && this.all.length > 3;
    },
    offered() {
      return this.hidden && !this.open ? this.all.filter((w) => this.has(w.value)) : this.all;
    },
    ranged() {
      return this.value && (this.open || this.value.low !== this.value.high);
    },
    chosen() {
      return this.value && this.f.members.find((m) => m.tag === this.value.type);
    },
  },
  methods: {
    EMPTY,
    plain,
    point(path) {
      document.dispatchEvent(new CustomEvent("scegen-field", { detail: path }));
    },
    meaning(value) {
      return (this.f.words.find((w) => w.value === value) || {}).means || this.f.means;
    },
    has(value) {
      return (this.value || []).includes(value);
    },
    set(value) {
      this.$emit("set", value);
    },
    toggle(value) {
      const now = this.value || [];
      this.set(this.has(value) ? now.filter((v) => v !== value) : [...now, value]);
    },
    shown(value) {
      return value === null || value === undefined ? "" : Number((value * this.f.factor).toFixed(3));
    },
    read(text) {
      return text === "" ? null : Number(text) / this.f.factor;
    },
    bound(end, text) {
      const number = this.read(text);
      if (number === null) return this.set(null);
      const range = { ...(this.value || {}), [end]: number };
      const other = end === "low" ? "high" : "low";
      // one value stays one value; an end that would cross the other takes it along
      if (!this.ranged || !(range.low <= range.high)) range[other] = number;
      this.set(range);
    },
    rename(box) {
      const name = box.value.trim().toLowerCase().replaceAll(/[^a-z0-9_]+/g, "_");
      if (name && name !== this.value) this.ctx.rename(this.value, name);
      box.value = this.value;
    },
    sequence(text) {
      const numbers = text.split(/[\s,;]+/).filter(Boolean).map((n) => Number(n) / this.f.factor);
      this.set(numbers.some(Number.isNaN) ? this.value : numbers);
    },
    member(tag) {
      const found = this.f.members.find((m) => m.tag === tag);
      this.set(found ? { type: tag, ...fresh(found.fields, this.ctx.names) } : null);
    },
  },
};

const Item = {
  name: "Item",
  components: { Field },
  template: `
    <div class="item" :class="{ open }">
      <span v-if="colour" class="swatch" :style="{ background: colour }"></span>
      <div class="item-fields">
        <Field v-for="f in shown" :key="f.name" :f="f" :value="value[f.name]" :path="path + '.' + f.name" :ctx="ctx"
          @set="(v) => $emit('set', { ...value, [f.name]: v })"></Field>
        <button v-if="rest" class="tag more" @click="open = !open" :aria-expanded="open"
          :aria-label="(open ? 'Fewer' : 'More') + ' fields'">{{ open ? 'less' : '+ ' + rest }}</button>
      </div>
      <button v-if="removable" class="remove" aria-label="Remove" data-tip="Remove" @click="$emit('remove')">×</button>
    </div>`,
  props: ["fields", "value", "path", "ctx", "removable", "colour", "only"],
  emits: ["set", "remove"],
  data: () => ({ open: false }),
  computed: {
    shown() {
      if (this.open) return this.fields;
      return this.fields.filter((f) => f.required || f.name === "kind" || this.only?.includes(f.name)
        || JSON.stringify(this.value[f.name] ?? null) !== JSON.stringify(f.default ?? null)
        || (this.ctx.standings[this.path + "." + f.name] && !EMPTY(this.value[f.name])));
    },
    rest() {
      return this.open ? 1 : this.fields.length - this.shown.length;
    },
  },
};

export default {
  components: { Item },
  template: `
    <div class="form" v-if="data">
      <section v-for="s in filled" :key="s.name" class="form-section" :class="'s-' + s.name">
        <h3 :data-tip="s.means">{{ s.label }}
          <span v-if="s.type === 'list' && count(s)" class="count">{{ count(s) }}</span>
          <button v-if="s.type === 'list'" class="add" :aria-label="'Add to ' + s.label" @click="add(s)">add</button>
          <button v-else-if="s.optional" class="add" @click="put(s.name, null)">remove</button>
        </h3>
        <template v-if="s.type === 'list'">
          <Item v-for="(item, n) in data[s.name]" :key="item.id || n" :fields="s.fields" :value="item"
            :path="s.name + '.' + key(s, item, n)" :ctx="ctx" :removable="removable(s, item)"
            :colour="s.name === 'participants' ? colours[item.id] : null"
            @set="(v) => change(s.name, n, v)" @remove="remove(s, item, n)"></Item>
        </template>
        <Item v-else-if="data[s.name]" :fields="s.fields" :value="data[s.name]" :path="s.name" :ctx="ctx"
          :only="s.name === 'environment' ? s.fields.map((f) => f.name) : []" @set="(v) => put(s.name, v)"></Item>
      </section>
      <div v-if="empty.length" class="form-rest"><span class="hint">Add</span>
        <button v-for="s in empty" :key="s.name" class="tag more" :data-tip="s.means"
          @click="begin(s)">{{ s.label }}</button>
      </div>
    </div>`,
  props: { spec: Array, scenario: Object, standings: Object, wrong: String, colours: Object, sections: Array },
  data() {
    return { data: copy(this.scenario) };
  },
  computed: {
    ordered() {
      const wanted = this.sections;
      return wanted.map((name) => this.spec.find((s) => s.name === name)).filter(Boolean);
    },
    filled() {
      return this.ordered.filter((s) => !this.isEmpty(s));
    },
    empty() {
      return this.ordered.filter((s) => this.isEmpty(s));
    },
    ctx() {
      const people = this.data.participants.map((p) => p.id);
      const acts = this.data.acts.map((a) => a.id);
      return {
        standings: this.standings,
        wrong: this.wrong,
        arms: this.data.junction.arms,
        names: {
          participants: [...people, ...this.data.objects.map((o) => o.id)],
          acts,
          moments: ["start", "contact", ...acts],
        },
        rename: (old, name) => this.$emit("rename", [old, name]),
        confirm: (path) => this.$emit("confirm", path),
      };
    },
  },
  watch: {
    scenario(now) {
      this.data = copy(now);
    },
  },
  methods: {
    isEmpty(s) {
      return s.type === "list" ? !this.count(s) : s.optional && !this.data[s.name];
    },
    begin(s) {
      if (s.type === "list") this.add(s);
      else this.put(s.name, this.first(s));
    },
    count(s) {
      return (this.data[s.name] || []).length;
    },
    key(s, item, n) {
      return item.id || (s.name === "hazards" ? item.kind : n);
    },
    removable(s, item) {
      return s.name !== "participants" || item.role !== "ego";
    },
    first(s) {
      return fresh(s.fields, this.ctx.names);
    },
    put(name, value) {
      this.data = { ...this.data, [name]: value };
      this.$emit("edit", this.data);
    },
    change(name, n, value) {
      this.put(name, this.data[name].map((old, m) => (m === n ? value : old)));
    },
    remove(s, item, n) {
      if (item.id) return this.$emit("forget", item.id);
      this.put(s.name, this.data[s.name].filter((_, m) => m !== n));
    },
    add(s) {
      const item = this.first(s);
      if (s.fields.some((f) => f.type === "id")) {
        const taken = new Set(["participants", "objects", "acts"].flatMap((l) => this.data[l].map((i) => i.id)));
        const stem = s.name === "acts" ? "act" : item.kind || "item";
        let n = 1;
        while (taken.has(stem + "_" + n)) n += 1;
        item.id = stem + "_" + n;
      }
      this.put(s.name, [...this.data[s.name], item]);
    },
  },
};
