// One labelled input: text, number or a choice of words. Keeps what is typed until it is changed.
export default {
  template: `
    <label class="entry" :class="{ wide, wrong }">
      <span v-if="label" class="entry-label" :data-tip="tip">{{ label }}</span>
      <select v-if="options" :value="value" :aria-label="label || hint" :disabled="disabled" @change="choose">
        <option v-for="option in options" :key="option.value" :value="option.value">{{ option.label }}</option>
      </select>
      <input v-else v-model="text" :type="kind" :min="min" :max="max" :step="step" :placeholder="hint"
        :aria-label="label || hint" :aria-invalid="wrong" :disabled="disabled" spellcheck="false" autocomplete="off"
        @change="commit" @keydown.enter.prevent="commit">
      <span v-if="unit" class="unit">{{ unit }}</span>
    </label>`,
  props: {
    value: [String, Number], kind: { type: String, default: "text" }, label: String, hint: String,
    options: Array, unit: String, min: Number, max: Number, step: [Number, String], tip: String,
    wide: Boolean, wrong: Boolean, disabled: Boolean,
  },
  data() {
    return { text: this.value ?? "" };
  },
  watch: {
    value(now) {
      this.text = now ?? "";
    },
  },
  methods: {
    commit() {
      this.$emit("value", this.kind === "number" ? (this.text === "" ? null : Number(this.text)) : this.text);
    },
    choose(event) {
      this.$emit("value", event.target.value);
    },
  },
};
