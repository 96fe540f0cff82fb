// Rules of one's own: a text that is sent when it is to be kept; a file is read here, in the browser.
export default {
  template: `
    <details class="rules" :open="!!value" @toggle="open = $event.target.open">
      <summary>Rules of your own</summary>
      <textarea ref="box" v-model="text" rows="5" :maxlength="longest" spellcheck="false"
        aria-label="Rules in answer set programming" placeholder=":- turns(ego,right).  % never"
        @keydown.enter.ctrl.prevent="keep" @keydown.enter.meta.prevent="keep"></textarea>
      <div class="row">
        <button type="button" class="button small" :class="{ primary: changed }" :disabled="!changed"
          @click="keep">{{ text.trim() || !value ? 'Keep them' : 'Drop them' }}</button>
        <label class="button small">From a file …<input type="file" accept=".lp,.txt" hidden @change="load"></label>
      </div>
      <div class="chips words" aria-label="What rules may ask for">
        <button v-for="word in words" :key="word.form" type="button" class="tag" :data-tip="word.means"
          @click="put(word.form)">{{ word.form }}</button>
      </div>
    </details>`,
  props: { value: String, words: Array, longest: Number },
  data() {
    return { text: this.value || "", open: false };
  },
  computed: {
    changed() {
      return this.text.trim() !== (this.value || "");
    },
  },
  watch: {
    value(now) {
      this.text = now || "";
    },
  },
  methods: {
    keep() {
      if (this.changed) this.$emit("keep", this.text);
    },
    async load(event) {
      const file = event.target.files[0];
      event.target.value = "";
      if (file) this.text = (await file.slice(0, this.longest).text()).slice(0, this.longest);
    },
    put(form) {
      const box = this.$refs.box;
      this.text = this.text.slice(0, box.selectionStart) + form + this.text.slice(box.selectionEnd);
      box.focus();
    },
  },
};
