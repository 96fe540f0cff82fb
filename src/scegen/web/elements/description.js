// The description: a text box behind whose words their standing is coloured while it is unchanged.
export default {
  template: `
    <div class="description" :class="{ changed }">
      <div class="description-marks" ref="marks" aria-hidden="true"
        ><template v-for="span in shown"><mark v-if="span.kind" :class="[span.kind, { lit: isLit(span) }]"
          :data-tip="span.tip">{{ span.text }}</mark><template v-else>{{ span.text }}</template></template>&#8203;</div>
      <textarea ref="box" v-model="text" :maxlength="longest" spellcheck="false" rows="4"
        aria-label="Description of the driving situation" :placeholder="placeholder"
        @input="typed" @scroll="follow" @mousemove="over" @mouseleave="leave"
        @keydown.enter.ctrl.prevent="submit" @keydown.enter.meta.prevent="submit"></textarea>
    </div>`,
  props: { value: String, spans: Array, longest: Number, placeholder: String },
  data() {
    return { text: this.value || "", lit: null, timer: null };
  },
  computed: {
    changed() {
      return this.spans.map((s) => s.text).join("") !== this.text;
    },
    shown() {
      return this.changed ? [{ text: this.text, kind: "" }] : this.spans;
    },
  },
  watch: {
    value(now) {
      this.text = now || "";
      this.$nextTick(this.follow);
    },
  },
  mounted() {
    this.listen = (event) => (this.lit = event.detail);
    document.addEventListener("scegen-field", this.listen);
  },
  unmounted() {
    document.removeEventListener("scegen-field", this.listen);
  },
  methods: {
    isLit(span) {
      return this.lit && (span.fields || []).some((f) => f === this.lit || f.startsWith(this.lit + "."));
    },
    typed() {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.$emit("draft", this.text), 250);
      this.follow();
    },
    submit() {
      clearTimeout(this.timer);
      this.$emit("submit", this.text);
    },
    put(text) {
      this.text = text;
      this.submit();
    },
    follow() {
      this.$refs.marks.scrollTop = this.$refs.box.scrollTop;
    },
    over(event) {
      // The box lies over the marks: look through it.
      const found = document.elementsFromPoint(event.clientX, event.clientY).find((e) => e.tagName === "MARK");
      window.scegenTip?.(found || null);
    },
    leave() {
      window.scegenTip?.(null);
    },
  },
};
