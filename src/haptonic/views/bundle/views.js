var Oy=Object.create;var zp=Object.defineProperty;var By=Object.getOwnPropertyDescriptor;var ky=Object.getOwnPropertyNames;var zy=Object.getPrototypeOf,Gy=Object.prototype.hasOwnProperty;var Vy=(n,e)=>()=>{try{return e||n((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var Hy=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of ky(e))!Gy.call(n,s)&&s!==t&&zp(n,s,{get:()=>e[s],enumerable:!(i=By(e,s))||i.enumerable});return n};var Wy=(n,e,t)=>(t=n!=null?Oy(zy(n)):{},Hy(e||!n||!n.__esModule?zp(t,"default",{value:n,enumerable:!0}):t,n));var x_=Vy(Hf=>{var h_=Object.defineProperty,PS=n=>h_(n,"__esModule",{value:!0}),IS=(n,e)=>{for(var t in e)h_(n,t,{get:e[t],enumerable:!0})};PS(Hf);IS(Hf,{GIFEncoder:()=>v_,applyPalette:()=>zS,default:()=>KS,nearestColor:()=>WS,nearestColorIndex:()=>g_,nearestColorIndexWithDistance:()=>__,prequantize:()=>kS,quantize:()=>OS,snapColorsToPalette:()=>HS});var LS={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};function f_(n=256){let e=0,t=new Uint8Array(n);return{get buffer(){return t.buffer},reset(){e=0},bytesView(){return t.subarray(0,e)},bytes(){return t.slice(0,e)},writeByte(s){i(e+1),t[e]=s,e++},writeBytes(s,r=0,o=s.length){i(e+o);for(let a=0;a<o;a++)t[e++]=s[a+r]},writeBytesView(s,r=0,o=s.byteLength){i(e+o),t.set(s.subarray(r,r+o),e),e+=o}};function i(s){var r=t.length;if(r>=s)return;var o=1024*1024;s=Math.max(s,r*(r<o?2:1.125)>>>0),r!=0&&(s=Math.max(s,256));let a=t;t=new Uint8Array(s),e>0&&t.set(a.subarray(0,e),0)}}var zf=12,l_=5003,DS=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function NS(n,e,t,i,s=f_(512),r=new Uint8Array(256),o=new Int32Array(l_),a=new Int32Array(l_)){let l=o.length,c=Math.max(2,i);r.fill(0),a.fill(0),o.fill(-1);let u=0,f=0,h=c+1,d=h,p=!1,y=d,_=(1<<y)-1,g=1<<h-1,b=g+1,E=g+2,S=0,P=t[0],C=0;for(let B=l;B<65536;B*=2)++C;C=8-C,s.writeByte(c),A(g);let v=t.length;for(let B=1;B<v;B++)e:{let N=t[B],L=(N<<zf)+P,k=N<<C^P;if(o[k]===L){P=a[k];break e}let V=k===0?1:l-k;for(;o[k]>=0;)if(k-=V,k<0&&(k+=l),o[k]===L){P=a[k];break e}A(P),P=N,E<1<<zf?(a[k]=E++,o[k]=L):(o.fill(-1),E=g+2,p=!0,A(g))}return A(P),A(b),s.writeByte(0),s.bytesView();function A(B){for(u&=DS[f],f>0?u|=B<<f:u=B,f+=y;f>=8;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,f-=8;if((E>_||p)&&(p?(y=d,_=(1<<y)-1,p=!1):(++y,_=y===zf?1<<y:(1<<y)-1)),B==b){for(;f>0;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,f-=8;S>0&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0)}}}var FS=NS;function d_(n,e,t){return n<<8&63488|e<<2&992|t>>3}function p_(n,e,t,i){return n>>4|e&240|(t&240)<<4|(i&240)<<8}function m_(n,e,t){return n>>4<<8|e&240|t>>4}function hc(n,e,t){return n<e?e:n>t?t:n}function Ua(n){return n*n}function c_(n,e,t){var i=0,s=1e100;let r=n[e],o=r.cnt,a=r.ac,l=r.rc,c=r.gc,u=r.bc;for(var f=r.fw;f!=0;f=n[f].fw){let d=n[f],p=d.cnt,y=o*p/(o+p);if(!(y>=s)){var h=0;t&&(h+=y*Ua(d.ac-a),h>=s)||(h+=y*Ua(d.rc-l),!(h>=s)&&(h+=y*Ua(d.gc-c),!(h>=s)&&(h+=y*Ua(d.bc-u),!(h>=s)&&(s=h,i=f))))}}r.err=s,r.nn=i}function Gf(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function US(n,e){let t=e==="rgb444"?4096:65536,i=new Array(t),s=n.length;if(e==="rgba4444")for(let r=0;r<s;++r){let o=n[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255,f=p_(u,c,l,a),h=f in i?i[f]:i[f]=Gf();h.rc+=u,h.gc+=c,h.bc+=l,h.ac+=a,h.cnt++}else if(e==="rgb444")for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=m_(c,l,a),f=u in i?i[u]:i[u]=Gf();f.rc+=c,f.gc+=l,f.bc+=a,f.cnt++}else for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=d_(c,l,a),f=u in i?i[u]:i[u]=Gf();f.rc+=c,f.gc+=l,f.bc+=a,f.cnt++}return i}function OS(n,e,t={}){let{format:i="rgb565",clearAlpha:s=!0,clearAlphaColor:r=0,clearAlphaThreshold:o=0,oneBitAlpha:a=!1}=t;if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(n.buffer),c=t.useSqrt!==!1,u=i==="rgba4444",f=US(l,i),h=f.length,d=h-1,p=new Uint32Array(h+1);for(var y=0,g=0;g<h;++g){let H=f[g];if(H!=null){var _=1/H.cnt;u&&(H.ac*=_),H.rc*=_,H.gc*=_,H.bc*=_,f[y++]=H}}Ua(e)/y<.022&&(c=!1);for(var g=0;g<y-1;++g)f[g].fw=g+1,f[g+1].bk=g,c&&(f[g].cnt=Math.sqrt(f[g].cnt));c&&(f[g].cnt=Math.sqrt(f[g].cnt));var b,E,S;for(g=0;g<y;++g){c_(f,g,!1);var P=f[g].err;for(E=++p[0];E>1&&(S=E>>1,!(f[b=p[S]].err<=P));E=S)p[E]=b;p[E]=g}var C=y-e;for(g=0;g<C;){for(var v;;){var A=p[1];if(v=f[A],v.tm>=v.mtm&&f[v.nn].mtm<=v.tm)break;v.mtm==d?A=p[1]=p[p[0]--]:(c_(f,A,!1),v.tm=g);var P=f[A].err;for(E=1;(S=E+E)<=p[0]&&(S<p[0]&&f[p[S]].err>f[p[S+1]].err&&S++,!(P<=f[b=p[S]].err));E=S)p[E]=b;p[E]=A}var B=f[v.nn],N=v.cnt,L=B.cnt,_=1/(N+L);u&&(v.ac=_*(N*v.ac+L*B.ac)),v.rc=_*(N*v.rc+L*B.rc),v.gc=_*(N*v.gc+L*B.gc),v.bc=_*(N*v.bc+L*B.bc),v.cnt+=B.cnt,v.mtm=++g,f[B.bk].fw=B.fw,f[B.fw].bk=B.bk,B.mtm=d}let k=[];var V=0;for(g=0;;++V){let F=hc(Math.round(f[g].rc),0,255),H=hc(Math.round(f[g].gc),0,255),Y=hc(Math.round(f[g].bc),0,255),G=255;u&&(G=hc(Math.round(f[g].ac),0,255),a&&(G=G<=(typeof a=="number"?a:127)?0:255),s&&G<=o&&(F=H=Y=r,G=0));let oe=u?[F,H,Y,G]:[F,H,Y];if(BS(k,oe)||k.push(oe),(g=f[g].fw)==0)break}return k}function BS(n,e){for(let t=0;t<n.length;t++){let i=n[t],s=i[0]===e[0]&&i[1]===e[1]&&i[2]===e[2],r=i.length>=4&&e.length>=4?i[3]===e[3]:!0;if(s&&r)return!0}return!1}function dc(n,e){var t=0,i;for(i=0;i<n.length;i++){let s=n[i]-e[i];t+=s*s}return t}function fc(n,e){return e>1?Math.round(n/e)*e:n}function kS(n,{roundRGB:e=5,roundAlpha:t=10,oneBitAlpha:i=null}={}){let s=new Uint32Array(n.buffer);for(let r=0;r<s.length;r++){let o=s[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255;a=fc(a,t),i&&(a=a<=(typeof i=="number"?i:127)?0:255),u=fc(u,e),c=fc(c,e),l=fc(l,e),s[r]=a<<24|l<<16|c<<8|u<<0}}function zS(n,e,t="rgb565"){if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let i=new Uint32Array(n.buffer),s=i.length,r=t==="rgb444"?4096:65536,o=new Uint8Array(s),a=new Array(r),l=t==="rgba4444";if(t==="rgba4444")for(let c=0;c<s;c++){let u=i[c],f=u>>24&255,h=u>>16&255,d=u>>8&255,p=u&255,y=p_(p,d,h,f),_=y in a?a[y]:a[y]=GS(p,d,h,f,e);o[c]=_}else{let c=t==="rgb444"?m_:d_;for(let u=0;u<s;u++){let f=i[u],h=f>>16&255,d=f>>8&255,p=f&255,y=c(p,d,h),_=y in a?a[y]:a[y]=VS(p,d,h,e);o[u]=_}}return o}function GS(n,e,t,i,s){let r=0,o=1e100;for(let a=0;a<s.length;a++){let l=s[a],c=l[3],u=Ur(c-i);if(u>o)continue;let f=l[0];if(u+=Ur(f-n),u>o)continue;let h=l[1];if(u+=Ur(h-e),u>o)continue;let d=l[2];u+=Ur(d-t),!(u>o)&&(o=u,r=a)}return r}function VS(n,e,t,i){let s=0,r=1e100;for(let o=0;o<i.length;o++){let a=i[o],l=a[0],c=Ur(l-n);if(c>r)continue;let u=a[1];if(c+=Ur(u-e),c>r)continue;let f=a[2];c+=Ur(f-t),!(c>r)&&(r=c,s=o)}return s}function HS(n,e,t=5){if(!n.length||!e.length)return;let i=n.map(o=>o.slice(0,3)),s=t*t,r=n[0].length;for(let o=0;o<e.length;o++){let a=e[o];a.length<r?a=[a[0],a[1],a[2],255]:a.length>r?a=a.slice(0,3):a=a.slice();let l=__(i,a.slice(0,3),dc),c=l[0],u=l[1];u>0&&u<=s&&(n[c]=a)}}function Ur(n){return n*n}function g_(n,e,t=dc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return s}function __(n,e,t=dc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return[s,i]}function WS(n,e,t=dc){return n[g_(n,e,t)]}function v_(n={}){let{initialCapacity:e=4096,auto:t=!0}=n,i=f_(e),s=5003,r=new Uint8Array(256),o=new Int32Array(s),a=new Int32Array(s),l=!1;return{reset(){i.reset(),l=!1},finish(){i.writeByte(LS.trailer)},bytes(){return i.bytes()},bytesView(){return i.bytesView()},get buffer(){return i.buffer},get stream(){return i},writeHeader:c,writeFrame(u,f,h,d={}){let{transparent:p=!1,transparentIndex:y=0,delay:_=0,palette:g=null,repeat:b=0,colorDepth:E=8,dispose:S=-1}=d,P=!1;if(t?l||(P=!0,c(),l=!0):P=!!d.first,f=Math.max(0,Math.floor(f)),h=Math.max(0,Math.floor(h)),P){if(!g)throw new Error("First frame must include a { palette } option");XS(i,f,h,g,E),u_(i,g),b>=0&&YS(i,b)}let C=Math.round(_/10);qS(i,S,C,p,y);let v=!!g&&!P;$S(i,f,h,v?g:null),v&&u_(i,g),ZS(i,u,f,h,E,r,o,a)}};function c(){y_(i,"GIF89a")}}function qS(n,e,t,i,s){n.writeByte(33),n.writeByte(249),n.writeByte(4),s<0&&(s=0,i=!1);var r,o;i?(r=1,o=2):(r=0,o=0),e>=0&&(o=e&7),o<<=2,n.writeByte(0|o|0|r),sr(n,t),n.writeByte(s||0),n.writeByte(0)}function XS(n,e,t,i,s=8){let a=Vf(i.length)-1,l=128|s-1<<4|0|a,c=0,u=0;sr(n,e),sr(n,t),n.writeBytes([l,c,u])}function YS(n,e){n.writeByte(33),n.writeByte(255),n.writeByte(11),y_(n,"NETSCAPE2.0"),n.writeByte(3),n.writeByte(1),sr(n,e),n.writeByte(0)}function u_(n,e){let t=1<<Vf(e.length);for(let i=0;i<t;i++){let s=[0,0,0];i<e.length&&(s=e[i]),n.writeByte(s[0]),n.writeByte(s[1]),n.writeByte(s[2])}}function $S(n,e,t,i){if(n.writeByte(44),sr(n,0),sr(n,0),sr(n,e),sr(n,t),i){let o=Vf(i.length)-1;n.writeByte(128|o)}else n.writeByte(0)}function ZS(n,e,t,i,s=8,r,o,a){FS(t,i,e,s,n,r,o,a)}function sr(n,e){n.writeByte(e&255),n.writeByte(e>>8&255)}function y_(n,e){for(var t=0;t<e.length;t++)n.writeByte(e.charCodeAt(t))}function Vf(n){return Math.max(Math.ceil(Math.log2(n)),1)}var KS=v_});async function Bh(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Response(e).arrayBuffer()}var Gp=8,qy={"<f8":Float64Array,"<f4":Float32Array,"<i4":Int32Array,"<i2":Int16Array,"|i1":Int8Array},va=class n{constructor(e,t,i){this.header=e;this.content=t;this.front=i}header;content;front;static read(e){let t=new DataView(e).getUint32(0,!0),i=new TextDecoder().decode(new Uint8Array(e,4,t)),s=Math.ceil((4+t)/Gp)*Gp;return new n(JSON.parse(i),e,s)}has(e){return e in this.header.variables}values(e){let{type:t,start:i,shape:s}=this.described(e);if(t===void 0||i===void 0)throw new Error(`${e} has no numbers`);let r=s.reduce((o,a)=>o*a,1);return new qy[t](this.content,this.front+i,r)}scale(e){return this.described(e).scale??1}texts(e){return this.described(e).texts??[]}shape(e){return this.described(e).shape}unit(e){return this.described(e).attrs.units??""}title(e){return this.described(e).attrs.long_name??e}parsed(e){return JSON.parse(String(this.header.attrs[e]))}described(e){let t=this.header.variables[e];if(t===void 0)throw new Error(`the dataset has no variable ${e}`);return t}};var St,Wp,Gh,Ys,kh,Il,qp,Rl,Xp,Vh,zh,Xy,xa=Symbol.for("pv"),Ll={},Dl=[],Yy=/^m(i|n|o|s|text|space)$/,Hh=Array.isArray,Wh=Dl.slice,Er=Object.assign;function Tr(n){n&&n.parentNode&&n.remove()}function Yp(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Wh.call(arguments,2):t),ya(n,o,i,s,null)}function ya(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:xa,__v:s||++Wp,__i:-1,__u:0};return!s&&St.vnode&&St.vnode(r),r}function ln(n){return n.children}function lo(n,e){this.props=n,this.context=e,this.__g=0}function $s(n,e){if(e==null)return n.__&&$s(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:$s(n)}function $y(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Er({constructor:xa},t)).__v=t.__v+1,St.vnode&&St.vnode(e),qh(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||$s(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Qp(s,e,r),t.__=t.__e=null,e.__e!=i&&$p(e))}function $p(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),$p(n)}function Vp(n){(8&n.__g||(n.__g|=8,Ys.push(n),Il++))&&kh==St.debounceRendering||((kh=St.debounceRendering)||queueMicrotask)(Zp)}function Zp(){try{for(var n,e=1;Ys.length;)Ys.length>e&&Ys.sort(qp),n=Ys.shift(),e=Ys.length,8&n.__g&&$y(n)}finally{(Il=Ys.length)&&(kh||queueMicrotask)(Zp)}}function Kp(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,y,_,g=i.__k||Dl,b=e.length;for(l=Zy(t,e,g,l,b),f=0;f<b;f++)(d=t.__k[f])!=null&&(h=~d.__i&&g[d.__i]||Ll,d.__i=f,_=qh(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&Xh(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),y=y||p,4&d.__u?(l=Jp(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&_!==void 0?l=_:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=y,l}function Zy(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,y=p,_=0,g=0,b=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=b[r]=ya(null,o):Hh(o)?o=b[r]=ya(ln,{children:o}):o.constructor===xa&&o.__b?o=b[r]=ya(o.type,o.props,o.key,o.ref,o.__v):b[r]=o,l=r+_,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Ky(o,t,l,y))&&(y--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?_--:c==l+1?_++:c!=l&&(c>l?_--:_++,g=1)):(~c||(s>p?_--:s<p&&_++),typeof o.type!="function"&&(o.__u|=4))):b[r]=null;if(g){for(u=[],f=[],r=0;r<s;r++)if((o=b[r])&&16&o.__u){for(_=0,h=u.length;_<h;)u[d=_+h>>1]<o.__i?_=d+1:h=d;u[_]=o.__i,f[r]=_+1}for(_=u.length;r--;)f[r]&&(f[r]==_?_--:b[r].__u|=4)}if(y)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=$s(a)),Yh(a,a));return i}function Jp(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Jp(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=$s(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Ky(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Hp(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Cl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Hp(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Hp(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=zh[e]||(zh[e]=Jy(e)),(n.__a||(n.__a={}))[e]=Vh,r=e!=(e=e.replace(Xp,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Jy(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Rl]==null)e[Rl]=Vh++;else if(e[Rl]<this.__a[n])return;return t(St.event?St.event(e):e)}}}function qh(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,y,_,g,b,E,S,P,C,v,A,B,N,L,k=e.type;if(e.constructor!==xa)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=Pl(u,r):r.push(u),a=r[0]||a),(u=St.__b)&&u(e);e:if(typeof k=="function"){h=o.length;try{if(g=e.props,b=(u=k.prototype)&&u.render,E=(u=k.contextType)&&i[u.__c],S=u?E?E.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(b?e.__c=d=new k(g,S):(e.__c=d=new lo(g,S),d.constructor=k,d.render=Qy),E&&E.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),b&&(d.__s||(d.__s=d.state),k.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Er({},d.__s)),Er(d.__s,k.getDerivedStateFromProps(g,d.__s)))),p=d.props,y=d.state,d.__v=e,t.__c){if(g!==p&&b&&!k.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(g,S),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(g,d.__s,S)===!1){e.__v!=t.__v&&(d.props=g,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),Dl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=$s(t);break e}d.componentWillUpdate&&d.componentWillUpdate(g,d.__s,S),b&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,y,_)})}else b&&!k.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),b&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=S,d.props=g,d.__P=n,d.__g&=-5,P=St.__r,C=b?25:0;do d.__g&=-9,P&&P(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++C<25);b&&(Dl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Er({},i,d.getChildContext())),b&&t.__c&&d.getSnapshotBeforeUpdate&&(_=d.getSnapshotBeforeUpdate(p,y)),v=u&&u.type===ln&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&Yh(V,V)}),t.__k=null),a=t.__k?$s(t,0):null),a=Kp(n,Hh(v)?v:[v],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(Tr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(V){if(o.length=h,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(N=r.indexOf(a||void 0))||(N=r.length);(L=r[N-1])&&L.nodeType==8;)N--;for(;N<r.length;N++)if(L=r[N])if(r[N]=null,A){if(L==B)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(B=Pl(A=L))}}if(!A){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;A=a}(u=Pl(A=e.__c.__z||(e.__c.__z=A)))?(e.__e=A,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Tr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||jp(e),St.__e(V,e,t)}}else a=e.__e=jy(t.__e,e,t,i,s,r,o,l,c,n);return(u=St.diffed)&&u(e),a}function Pl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function jp(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(jp))}function Qp(n,e,t){for(var i=0;i<t.length;)Xh(t[i++],t[i++],t[i++]);St.__c&&St.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){St.__e(r,s.__v)}})}function jy(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,y,_,g,b=t.props||Ll,E=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(S?p.localName==S:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!S)return g.createTextNode(E);n=g.createElementNS(s,S,E.is?E:c),a&&(St.__m&&St.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&E.defaultValue!=null?null:r&&Wh.call(c.childNodes),!a&&r)for(b={},u=0;u<n.attributes.length;u++)b[(p=n.attributes[u]).name]=p.value;for(u in b)p=b[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in E||u=="value"&&"defaultValue"in E||u=="checked"&&"defaultChecked"in E||Cl(n,u,null,p,s);for(u in E)p=E[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?y=p:u=="checked"?_=p:a&&typeof p!="function"||b[u]===p||Cl(n,u,p,b[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Yy.test(S))&&(s="http://www.w3.org/1999/xhtml"),Kp(c,Hh(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&$s(t,0),a,l),r&&r.some(Tr)),a&&S!="textarea"||(u="value",S=="progress"&&y==null?n.removeAttribute(u):y==null||y===n[u]&&(S!="progress"||y)||Cl(n,u,y,b[u],s),u="checked",_!=null&&_!=n[u]&&Cl(n,u,_,b[u],s))}else b===E||a&&n.data==E||(n.data=E);return n}function Xh(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){St.__e(s,t)}}function Yh(n,e,t){var i,s,r,o;if(St.unmount&&St.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Xh(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){St.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Yh(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Pl(i,r=[]))&&(i==n.__e&&r.some(Tr),Tr(s),Tr(i)),t||Tr(n.__e),n.__e=n.__c=n.__=null}function Qy(n,e,t){return this.constructor(n,t)}function $h(n,e){var t,i,s,r;St.__&&St.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=ya(ln,{children:[n]}),s=[],r=[],qh(e,e.__k,i||Ll,Ll,e.namespaceURI,i?null:e.firstChild?Wh.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Qp(s,e.__k,r),e.__k.props.children=null}St={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Il=0,n}},Wp=0,Gh=function(n){return n!=null&&n.constructor===xa},lo.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Er({},this.state)),typeof n=="function"&&(n=n(Er({},t),this.props)),n&&(Er(t,n),this.__v&&(e&&this.__k.push(e),Vp(this)))},lo.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Vp(this))},lo.prototype.render=ln,Ys=[],Il=0,qp=function(n,e){return n.__v.__b-e.__v.__b},Rl=Symbol(),Xp=/(PointerCapture)$|Capture$/i,Vh=0,zh={},Xy=0;var co,yn,Zh,em,Kh=Object.is,Nl=0,cm=[],Jh=[],hn=St,tm=hn.__b,nm=hn.__r,im=hn.diffed,sm=hn.__c,rm=hn.unmount,om=hn.__;function Fl(n,e){hn.__h&&hn.__h(yn,n,Nl||e),Nl=0;var t=yn.__H||(yn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Zs(n){return Nl=1,ex(um,n)}function ex(n,e,t){var i=Fl(co++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):um(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Kh(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=yn,!yn.__f)){yn.__f=!0;var s=yn.shouldComponentUpdate;yn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,Kh(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function fn(n,e){var t=Fl(co++,3);!hn.__s&&Qh(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,yn.__H.__h.push(t))}function Gi(n,e){var t=Fl(co++,4);!hn.__s&&Qh(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,yn.__h.push(t))}function Nt(n){return Nl=5,Ge(function(){return{current:n}},[])}function Ge(n,e){var t=Fl(co++,7);return Qh(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function tx(){var n;do{for(;n=Jh.shift();)try{ba(n)}catch(t){hn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=cm.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(ba),e.__h.some(jh),e.__h=[]}catch(t){e.__h=[],hn.__e(t,n.__v)}}}while(Jh.length)}hn.__b=function(n){yn=null,tm&&tm(n)},hn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),om&&om(n,e)},hn.__r=function(n){nm&&nm(n),co=0;var e=(yn=n.__c).__H;e&&(Zh==yn?yn.__h=[]:(e.__h.some(ba),e.__h.some(jh),co=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Zh=yn},hn.diffed=function(n){im&&im(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&lm(cm.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Zh=yn=null},hn.__c=function(n,e){e.some(function(t){try{t.__h.some(ba),t.__h=t.__h.filter(function(i){return!i.__||jh(i)})}catch(i){t.__h=[function(){throw i}]}}),sm&&sm(n,e)},hn.unmount=function(n){rm&&rm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,lm(Jh.push(s))}else ba(s)}catch(r){e=r}}),i.__H=void 0,e&&hn.__e(e,i.__v))};var am=typeof requestAnimationFrame=="function";function nx(n){var e,t=function(){clearTimeout(i),am&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);am&&(e=requestAnimationFrame(t))}function lm(n){n!=1&&em==hn.requestAnimationFrame||((em=hn.requestAnimationFrame)||nx)(tx)}function ba(n){var e=yn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),yn=e}function jh(n){var e=yn;n.__c=n.__(),yn=e}function Qh(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Kh(t,n[i])})}function um(n,e){return typeof e=="function"?e(n):e}var ix=Symbol.for("preact-signals");function kl(){if(ws>1)ws--;else{var n,e=!1;for((function(){var s=Ol;for(Ol=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();Ma!==void 0;){var t=Ma;for(Ma=void 0,Ul++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&fm(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(Ul=0,ws--,e)throw n}}function zl(n){if(ws>0)return n();ef=++sx,ws++;try{return n()}finally{kl()}}var Sa,Jt=void 0;function wa(n){var e=Jt,t=Sa;Jt=void 0,Sa=void 0;try{return n()}finally{Jt=e,Sa=t}}var Ma=void 0,ws=0,Ul=0,sx=0,ef=0,Ol=void 0,Bl=0;function hm(n){if(Jt!==void 0){var e=n.n;if(e===void 0||e.t!==Jt)return e={i:0,S:n,p:Jt.s,n:void 0,t:Jt,e:void 0,x:void 0,r:e},Jt.s!==void 0&&(Jt.s.n=e),Jt.s=e,n.n=e,32&Jt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=Jt.s,e.n=void 0,Jt.s.n=e,Jt.s=e),e}}function Tn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Tn.prototype.brand=ix;Tn.prototype.h=function(){return!0};Tn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:wa(function(){var i;(i=e.W)==null||i.call(e)}))};Tn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&wa(function(){var s;(s=e.Z)==null||s.call(e)}))}};Tn.prototype.subscribe=function(n){var e=this;return Et(function(){var t=e.value;wa(function(){return n(t)})},{name:"sub"})};Tn.prototype.valueOf=function(){return this.value};Tn.prototype.toString=function(){return this.value+""};Tn.prototype.toJSON=function(){return this.value};Tn.prototype.peek=function(){var n=this;return wa(function(){return n.value})};Object.defineProperty(Tn.prototype,"value",{get:function(){var n=hm(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Ul>100)throw new Error("Cycle detected");(function(t){ws!==0&&Ul===0&&t.l!==ef&&(t.l=ef,Ol={S:t,v:t.v,i:t.i,o:Ol})})(this),this.v=n,this.i++,Bl++,ws++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{kl()}}}});function Xe(n,e){return new Tn(n,e)}function fm(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function dm(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function pm(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function Ar(n,e){Tn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Bl-1,this.f=4}Ar.prototype=new Tn;Ar.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Bl))return!0;if(this.g=Bl,this.f|=1,this.i>0&&!fm(this))return this.f&=-2,!0;var n=Jt;try{dm(this),Jt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return Jt=n,pm(this),this.f&=-2,!0};Ar.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Tn.prototype.S.call(this,n)};Ar.prototype.U=function(n){if(this.t!==void 0&&(Tn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};Ar.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(Ar.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=hm(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function xn(n,e){return new Ar(n,e)}function mm(n){var e=n.j;if(n.j=void 0,typeof e=="function"){ws++;var t=Jt;Jt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,tf(n),i}finally{Jt=t,kl()}}}function tf(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,mm(n)}function rx(n){if(Jt!==this)throw new Error("Out-of-order effect");pm(this),Jt=n,this.f&=-2;try{8&this.f&&tf(this)}finally{kl()}}function uo(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,Sa&&Sa.push(this)}uo.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};uo.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,mm(this),dm(this),ws++;var n=Jt;return Jt=this,rx.bind(this,n)};uo.prototype.N=function(){2&this.f||(this.f|=2,this.u=Ma,Ma=this)};uo.prototype.d=function(){this.f|=8,1&this.f||tf(this)};uo.prototype.dispose=function(){this.d()};function Et(n,e){var t=new uo(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var nf,Ea,Gl,ox=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,gm=[],_m=[];Et(function(){nf=this.N})();function ho(n,e){St[n]=e.bind(null,St[n]||function(){})}function Ta(n){if(Gl){var e=Gl;Gl=void 0,e()}Gl=n&&n.S()}function vm(n){var e=this,t=n.data,i=lx(t);i.name="ReactiveDom",i.value=t;var s=Ge(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=xn(function(){var d=i.value.value;return d===0?0:d===!0?"":d||""}),u=xn(function(){return!Array.isArray(c.value)&&!Gh(c.value)}),f=Et(function(){if(this.N=ym,u.value){var d=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=d)}}),h=e.__$u.d;return e.__$u.d=function(){f(),h.call(this)},[u,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}vm.displayName="ReactiveTextNode";Object.defineProperties(Tn.prototype,{constructor:{configurable:!0,value:Yp(ln,null).constructor},type:{configurable:!0,value:vm},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});ho("__b",function(n,e){if(Ta(),Ea=void 0,typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Tn&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});ho("__r",function(n,e){if(n(e),e.type!==ln){Ta();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return Et(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;ox&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),Ea=i,Ta(t)}});ho("__e",function(n,e,t,i){Ta(),Ea=void 0,n(e,t,i)});ho("diffed",function(n,e){Ta(),Ea=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=ax(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function ax(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=Xe(t);return{o:function(o,a){r.value=o,i=a},d:Et(function(){this.N=ym;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}ho("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});ho("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});lo.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function lx(n,e){return Ge(function(){return Xe(n,e)},[])}var cx=typeof requestAnimationFrame>"u"?setTimeout:function(n){var e=function(){clearTimeout(t),cancelAnimationFrame(i),n()},t=setTimeout(e,35),i=requestAnimationFrame(e)},ux=function(n){queueMicrotask(function(){queueMicrotask(n)})};function hx(){zl(function(){for(var n;n=gm.shift();)nf.call(n)})}function fx(){gm.push(this)===1&&(St.requestAnimationFrame||cx)(hx)}function dx(){zl(function(){for(var n;n=_m.shift();)nf.call(n)})}function ym(){_m.push(this)===1&&(St.requestAnimationFrame||ux)(dx)}function xm(n,e){var t=Nt(n);t.current=n;var i=Ea;fn(function(){return Et(function(){if(this.N=fx,!(i&&8&i.__$f))return t.current()},e)},[])}var bm=[{name:"Hz",factor:1},{name:"kHz",factor:1e3},{name:"MHz",factor:1e6}],px=1e4,Aa=Xe({});function Ci(n){let{pitch_m:e,shear_speed_m_per_s:t}=n.header.attrs;return typeof e!="number"||typeof t!="number"?bm:[...bm,{name:"ωa/(2πcₜ)",factor:t/e,relative:!0}]}function Ri(n,e){return n.find(({factor:i,relative:s})=>!s&&e<px*i)??n[0]}function fo(n){return[{name:"rad/m",factor:1},{name:"π/a",factor:Math.PI/n},{name:"2π/a",factor:2*Math.PI/n}]}function kn(n,{name:e,relative:t}){return t?`${e} = ${n}`:`${n} ${e}`}function Xt(n,{name:e,relative:t}){return t?e:`${n} / ${e.includes("/")?`(${e})`:e}`}function ls(n){return`${Number(n.toPrecision(6))}`}var mx=Symbol.for("pv"),gx=0;function m(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:mx,__v:--gx,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),St.vnode&&St.vnode(c),c}function Pi({title:n,units:e,unit:t}){let{value:i}=t,s=e[0]?.name??"";return fn(()=>{Aa.value={...Aa.peek(),[s]:i}},[s,i]),fn(()=>()=>{let{[s]:r,...o}=Aa.peek();Aa.value=o},[s]),m("label",{children:[n," ",m("select",{value:i.name,onChange:({currentTarget:r})=>t.value=e[r.selectedIndex]??t.value,children:e.map(({name:r})=>m("option",{children:r}))})]})}function Cr({playing:n}){return m("button",{type:"button",onClick:()=>n.value=!n.value,children:n.value?"Stop":"Move"})}function po({playing:n,pace:e}){return m("div",{class:"controls",children:[m(Cr,{playing:n}),m(Ca,{pace:e})]})}function Ca({pace:n}){return m("label",{children:["pace, cycles per second: ",n.value.toFixed(1),m("input",{type:"range",min:"0.1",max:"3",step:"0.1",value:n.value,onInput:e=>n.value=Number(e.currentTarget.value)})]})}function Ii({facts:n}){return m("dl",{children:n.filter(([,e])=>e).map(([e,t])=>m("div",{children:[m("dt",{children:e}),m("dd",{children:t})]}))})}var Vl=Xe([]);function Sm(n,e){let t={title:n,keys:e};return Vl.value=[...Vl.peek(),t],()=>Vl.value=Vl.peek().filter(i=>i!==t)}var cs=({playing:n})=>({keys:"space",effect:"move or stop",actions:{" ":()=>n.value=!n.value}}),_x="input, textarea, select",vx="button, summary, a";function Hl(n,e){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return;let t=n.target;if(t.closest(_x)!==null||n.key===" "&&t.closest(vx)!==null)return;let i=e.map(s=>s.actions[n.key]).find(s=>s!==void 0);i!==void 0&&(n.preventDefault(),i(n))}var Vi=n=>String(n.header.attrs.origin??"simulated");function Jn({name:n,data:e,keys:t,foot:i,isOld:s=!1,children:r}){fn(()=>Sm(e.header.title,t),[e,t]);let o=e.header.extra.summary??[];return m("div",{class:n,tabIndex:-1,onKeyDown:a=>Hl(a,t),children:[m("header",{children:[m("h1",{children:e.header.title}),m("p",{class:"origin",children:Vi(e)}),m("div",{class:s?"old":"",children:o.map(a=>m("p",{children:a}))})]}),r,m("footer",{children:m("p",{children:["haptonic ",String(e.header.attrs.haptonic_version??""),". ",i]})})]})}function ni(n){return[{keys:"t",effect:"tables",actions:{t:()=>sf(n,"table")}},{keys:"?",effect:"this list",actions:{"?":()=>sf(n,"keys")}}]}function sf(n,e){n.value=n.value===e?"none":e}function ii({listing:n,keys:e,children:t}){let i=Nt(null);return xm(()=>{n.value!=="none"&&i.current?.focus()}),m("section",{"aria-label":"Tables and keys",children:[m("p",{class:"opened",children:[["table","Tables"],["keys","Keys"]].map(([r,o])=>m("button",{type:"button","aria-expanded":n.value===r,onClick:()=>sf(n,r),children:o}))}),m("div",{ref:i,tabIndex:-1,children:[n.value==="table"&&t,n.value==="keys"&&m(yx,{title:"Keys",keys:e})]})]})}function yx({title:n,keys:e}){return m("table",{children:[n&&m("caption",{children:n}),m("tbody",{children:e.map(({keys:t,effect:i})=>m("tr",{children:[m("th",{scope:"row",children:m("kbd",{children:t})}),m("td",{children:i})]}))})]})}function Gt(n,e){if(!(Number.isFinite(e)&&e>0))return n.toFixed(3);e=Math.max(e,10**-6);let t=Math.floor(Math.log10(e)+1e-9);e<2*10**t&&(t-=1);let i=Math.ceil(e/10**t-1e-9);i===10&&([i,t]=[1,t+1]);let s=Math.min(Math.max(-t,0),6);return`${n.toFixed(s)} ± ${(i*10**t).toFixed(s)}`}function Wl([n,e],t){let i=Math.hypot(n,e);if(t===void 0)return`${i.toPrecision(3)} m/s`;let s=i>t?` at ${(Math.atan2(e,n)*180/Math.PI).toFixed(0)}° from x`:"";return`${Gt(i,t)} m/s${s}`}function Vn({label:n,describedBy:e="point",onKeyDown:t,children:i}){return m("div",{class:"walk",tabIndex:0,role:"application","aria-label":n,"aria-describedby":e,onKeyDown:t,children:i})}var xx="uplot",bx="u-hz",Sx="u-vt",Mx="u-title",wx="u-wrap",Tx="u-under",Ex="u-over",Ax="u-axis",Ir="u-off",Cx="u-select",Rx="u-cursor-x",Px="u-cursor-y",Ix="u-cursor-pt",Lx="u-legend",Dx="u-live",Nx="u-inline",Fx="u-series",Ux="u-marker",Mm="u-label",Ox="u-value",Pa="width",Ia="height";var wm="bottom",mo="left",rf="right",Sf="#000",Tm=Sf+"0",of="mousemove",Em="mousedown",af="mouseup",Am="mouseenter",Cm="mouseleave",Rm="dblclick",Bx="resize",kx="scroll",Pm="change",Zl="dppxchange",Mf="--",So=typeof window<"u",ff=So?document:null,_o=So?window:null,zx=So?navigator:null,At,ql;function df(){let n=devicePixelRatio;At!=n&&(At=n,ql&&mf(Pm,ql,df),ql=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),Lr(Pm,ql,df),_o.dispatchEvent(new CustomEvent(Zl)))}function di(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function pf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Hi(n,e,t,i){let s=ff.createElement(n);return e!=null&&di(s,e),t?.insertBefore(s,i),s}function Li(n,e){return Hi("div",n,e)}var Im=new WeakMap;function us(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Im.get(n);r!=o&&(n.style.transform=r,Im.set(n,r),e<0||t<0||e>i||t>s?di(n,Ir):pf(n,Ir))}var Lm=new WeakMap;function Dm(n,e,t){let i=e+t,s=Lm.get(n);i!=s&&(Lm.set(n,i),n.style.background=e,n.style.borderColor=t)}var Nm=new WeakMap;function Fm(n,e,t,i){let s=e+""+t,r=Nm.get(n);s!=r&&(Nm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var wf={passive:!0},Gx={...wf,capture:!0};function Lr(n,e,t,i){e.addEventListener(n,t,i?Gx:wf)}function mf(n,e,t,i){e.removeEventListener(n,t,wf)}So&&df();function Wi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:pi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function cg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var ug=n=>n!=null,hg=n=>n!=null&&n>0,jl=cg(ug),Vx=cg(hg);function Hx(n,e,t,i=0,s=!1){let r=s?Vx:jl,o=s?hg:ug;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function Ql(n,e,t,i){let s=Bm(n),r=Bm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ts:fg,a=s==1?pi:Di,l=r==1?Di:pi,c=a(o(An(n))),u=l(o(An(e))),f=vo(t,c),h=vo(t,u);return t==10&&(c<0&&(f=kt(f,-c)),u<0&&(h=kt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=gg(n,f),e=ec(e,h)),[n,e]}function Tf(n,e,t,i){let s=Ql(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Ef=.1,Um={mode:3,pad:Ef},Da={pad:0,soft:null,mode:0},Wx={min:Da,max:Da};function Kl(n,e,t,i){return tc(t)?Om(n,e,t):(Da.pad=t,Da.soft=i?0:null,Da.mode=i?3:0,Om(n,e,Wx))}function wt(n,e){return n??e}function qx(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Om(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Bt),l=wt(s.hard,Bt),c=wt(i.soft,Bt),u=wt(s.soft,-Bt),f=wt(i.mode,0),h=wt(s.mode,0),d=e-n,p=Ts(d),y=jn(An(n),An(e)),_=Ts(y),g=An(_-p);(d<1e-24||g>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Bt&&(r=0),h==2&&u!=-Bt&&(o=0)));let b=d||y||1e3,E=Ts(b),S=vo(10,pi(E)),P=b*(d==0?n==0?.1:1:r),C=kt(gg(n-P,S/10),24),v=n>=c&&(f==1||f==3&&C<=c||f==2&&C>=c)?c:Bt,A=jn(a,C<v&&n>=v?v:qi(v,C)),B=b*(d==0?e==0?.1:1:o),N=kt(ec(e+B,S/10),24),L=e<=u&&(h==1||h==3&&N>=u||h==2&&N<=u)?u:-Bt,k=qi(l,N>L&&e<=L?L:jn(L,N));return A==k&&A==0&&(k=100),[A,k]}var Xx=new Intl.NumberFormat(So?zx.language:"en-US"),Af=n=>Xx.format(n),mi=Math,$l=mi.PI,An=mi.abs,pi=mi.floor,En=mi.round,Di=mi.ceil,qi=mi.min,jn=mi.max,vo=mi.pow,Bm=mi.sign,Ts=mi.log10,fg=mi.log2,Yx=(n,e=1)=>mi.sinh(n)*e,lf=(n,e=1)=>mi.asinh(n/e),Bt=1/0;function km(n){return(Ts((n^n>>31)-(n>>31))|0)+1}function gf(n,e,t){return qi(jn(n,e),t)}function dg(n){return typeof n=="function"}function vt(n){return dg(n)?n:()=>n}var $x=()=>{},pg=n=>n,mg=(n,e)=>e,Zx=n=>null,zm=n=>!0,Gm=(n,e)=>n==e,Kx=/\.\d*?(?=9{6,}|0{6,})/gm,Dr=n=>{if(vg(n)||Js.has(n))return n;let e=`${n}`,t=e.match(Kx);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Dr(s)}e${r}`}return kt(n,i)};function Rr(n,e){return Dr(kt(Dr(n/e))*e)}function ec(n,e){return Dr(Di(Dr(n/e))*e)}function gg(n,e){return Dr(pi(Dr(n/e))*e)}function kt(n,e=0){if(vg(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return En(i)/t}var Js=new Map;function _g(n){return((""+n).split(".")[1]||"").length}function Fa(n,e,t,i){let s=[],r=i.map(_g);for(let o=e;o<t;o++){let a=An(o),l=kt(vo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:kt(u,f);s.push(h),Js.set(h,f)}}return s}var Na={},Cf=[],yo=[null,null],Ks=Array.isArray,vg=Number.isInteger,Jx=n=>n===void 0;function Vm(n){return typeof n=="string"}function tc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function jx(n){return n!=null&&typeof n=="object"}var Qx=Object.getPrototypeOf(Uint8Array),yg="__proto__";function xo(n,e=tc){let t;if(Ks(n)){let i=n.find(s=>s!=null);if(Ks(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=xo(n[s],e)}else t=n.slice()}else if(n instanceof Qx)t=n.slice();else if(e(n)){t={};for(let i in n)i!=yg&&(t[i]=xo(n[i],e))}else t=n;return t}function bn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=yg&&(tc(n[s])?bn(n[s],xo(i[s])):n[s]=xo(i[s]))}return n}var eb=0,tb=1,nb=2;function ib(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function sb(n,e){if(ab(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return lb(o[0])||(o=ob(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:tb,d=[];for(let p=0;p<u.length;p++){let y=u[p],_=r.get(l[p]);y===null?h!=eb&&(f[_]=y,h==nb&&d.push(_)):f[_]=y}ib(f,d,s),i.push(f)}}return i}var rb=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function ob(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function ab(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function lb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=jn(1,pi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var xg=["January","February","March","April","May","June","July","August","September","October","November","December"],bg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Sg(n){return n.slice(0,3)}var cb=bg.map(Sg),ub=xg.map(Sg),hb={MMMM:xg,MMM:ub,WWWW:bg,WWW:cb};function Ra(n){return(n<10?"0":"")+n}function fb(n){return(n<10?"00":n<100?"0":"")+n}var db={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ra(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ra(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ra(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ra(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ra(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>fb(n.getMilliseconds())};function Rf(n,e){e=e||hb;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?db[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var pb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function mb(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==pb?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Mg=n=>n%1==0,Jl=[1,2,2.5,5],gb=Fa(10,-32,0,Jl),wg=Fa(10,0,32,Jl),_b=wg.filter(Mg),Pr=gb.concat(wg),Pf=`
`,Tg="{YYYY}",Hm=Pf+Tg,Eg="{M}/{D}",La=Pf+Eg,Xl=La+"/{YY}",Ag="{aa}",vb="{h}:{mm}",go=vb+Ag,Wm=Pf+go,qm=":{ss}",Rt=null;function Cg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Fa(10,0,3,Jl).filter(Mg):Fa(10,-3,0,Jl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Tg,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",Hm,Rt,Rt,Rt,Rt,Rt,1],[s,Eg,Hm,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+Ag,Xl,Rt,La,Rt,Rt,Rt,1],[t,go,Xl,Rt,La,Rt,Rt,Rt,1],[e,qm,Xl+" "+go,Rt,La+" "+go,Rt,Wm,Rt,1],[n,qm+".{fff}",Xl+" "+go,Rt,La+" "+go,Rt,Wm,Rt,1]];function u(f){return(h,d,p,y,_,g)=>{let b=[],E=_>=o,S=_>=r&&_<o,P=f(p),C=kt(P*n,3),v=cf(P.getFullYear(),E?0:P.getMonth(),S||E?1:P.getDate()),A=kt(v*n,3);if(S||E){let B=S?_/r:0,N=E?_/o:0,L=C==A?C:kt(cf(v.getFullYear()+N,v.getMonth()+B,1)*n,3),k=new Date(En(L/n)),V=k.getFullYear(),F=k.getMonth();for(let H=0;L<=y;H++){let Y=cf(V+N*H,F+B*H,1),G=Y-f(kt(Y*n,3));L=kt((+Y+G)*n,3),L<=y&&b.push(L)}}else{let B=_>=s?s:_,N=pi(p)-pi(C),L=A+N+ec(C-A,B);b.push(L);let k=f(L),V=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,F=_/i,H=h.axes[d]._space,Y=g/H;for(;L=kt(L+_,n==1?0:3),!(L>y);)if(F>1){let G=pi(kt(V+F,6))%24,Q=f(L).getHours()-G;Q>1&&(Q=-1),L-=Q*i,V=(V+F)%24;let se=b[b.length-1];kt((L-se)/_,3)*Y>=.7&&b.push(L)}else b.push(L)}return b}}return[l,c,u]}var[yb,xb,bb]=Cg(1),[Sb,Mb,wb]=Cg(.001);Fa(2,-53,53,[1]);function Xm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Ym(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let y=n(p),_=y.getFullYear(),g=y.getMonth(),b=y.getDate(),E=y.getHours(),S=y.getMinutes(),P=y.getSeconds(),C=_!=l&&a[2]||g!=c&&a[3]||b!=u&&a[4]||E!=f&&a[5]||S!=h&&a[6]||P!=d&&a[7]||a[1];return l=_,c=g,u=b,f=E,h=S,d=P,C(y)})}}function Tb(n,e){let t=Rf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function cf(n,e,t){return new Date(n,e,t)}function $m(n,e){return e(n)}var Eb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Zm(n,e){return(t,i,s,r)=>r==null?Mf:e(n(i))}function Ab(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Cb(n,e){return n.series[e].fill(n,e)}var Rb={show:!0,live:!0,isolate:!1,mount:$x,markers:{show:!0,width:2,stroke:Ab,fill:Cb,dash:"solid"},idx:null,idxs:null,values:[]};function Pb(n,e){let t=n.cursor.points,i=Li(),s=t.size(n,e);Yt(i,Pa,s),Yt(i,Ia,s);let r=s/-2;Yt(i,"marginLeft",r),Yt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Yt(i,"borderWidth",o),i}function Ib(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Lb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Db(n,e){return n.series[e].points.size}var uf=[0,0];function Nb(n,e,t){return uf[0]=e,uf[1]=t,uf}function Yl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function hf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var Fb={show:!0,x:!0,y:!0,lock:!1,move:Nb,points:{one:!1,show:Pb,size:Db,width:0,stroke:Lb,fill:Ib},bind:{mousedown:Yl,mouseup:Yl,click:Yl,dblclick:Yl,mousemove:hf,mouseleave:hf,mouseenter:hf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Rg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},If=bn({},Rg,{filter:mg}),Pg=bn({},If,{size:10}),Ig=bn({},Rg,{show:!1}),Lf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Lg="bold "+Lf,Dg=1.5,Km={show:!0,scale:"x",stroke:Sf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Lg,side:2,grid:If,ticks:Pg,border:Ig,font:Lf,lineGap:Dg,rotate:0},Ub="Value",Ob="Time",Jm={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function Bb(n,e,t,i,s){return e.map(r=>r==null?"":Af(r))}function kb(n,e,t,i,s,r,o){let a=[],l=Js.get(s)||0;t=o?t:kt(ec(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function _f(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ts:fg,u=pi(c(t));s=vo(l,u),l==10&&(s=Pr[Wi(s,Pr)]);let f=t,h=s*l;l==10&&(h=Pr[Wi(h,Pr)]);do a.push(f),f=f+s,l==10&&!Js.has(f)&&(f=kt(f,Js.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Pr[Wi(h,Pr)]));while(f<=i);return a}function zb(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?_f(n,e,jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?_f(n,e,jn(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Ng=/./,Gb=/[12357]/,Vb=/[125]/,jm=/1/,vf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Hb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?Ng:l(7,o)-u>=c?Gb:l(5,o)-u>=c?Vb:jm;if(f==jm){let h=An(l(1,o)-u);if(h<c)return vf(e.slice().reverse(),a.distr,f,Di(c/h)).reverse()}return vf(e,a.distr,f,1)}function Wb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=An(l(1,o)-l(2,o));return c<a?vf(e.slice().reverse(),3,Ng,Di(a/c)).reverse():e}function qb(n,e,t,i){return i==null?Mf:e==null?"":Af(e)}var Qm={show:!0,scale:"y",stroke:Sf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Lg,side:3,grid:If,ticks:Pg,border:Ig,font:Lf,lineGap:Dg,rotate:0};function Xb(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function Yb(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=An(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var eg={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},Fg=(n,e,t,i,s)=>s,tg={show:!0,auto:!0,sorted:0,gaps:Fg,alpha:1,facets:[bn({},eg,{scale:"x"}),bn({},eg,{scale:"y"})]},ng={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Fg,alpha:1,points:{show:Yb,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function $b(n,e,t,i,s){return t/10}var Ug={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Zb=bn({},Ug,{time:!1,ori:1}),ig={};function Og(n,e){let t=ig[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(ig[n]=t)),t}var bo=1,yf=2;function Nr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,y=a.height,_=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,f,_,g,h,d,p,y,ic,Mo,rc,kg,Gg):t(s,l,c,u,f,g,_,d,h,y,p,sc,wo,Ff,zg,Vg)}function Df(n,e){let t=0,i=0,s=wt(n.bands,Cf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Kb(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Es(n,e,t,i,s,r){return Nr(n,e,(o,a,l,c,u,f,h,d,p,y,_)=>{let g=o.pxRound,b=c.dir*(c.ori==0?1:-1),E=c.ori==0?Mo:wo,S,P;b==1?(S=t,P=i):(S=i,P=t);let C=g(f(a[S],c,y,d)),v=g(h(l[S],u,_,p)),A=g(f(a[P],c,y,d)),B=g(h(r==1?u.max:u.min,u,_,p)),N=new Path2D(s);return E(N,A,B),E(N,C,B),E(N,C,v),N})}function nc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?rc:Ff,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Jb(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Nf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),y=f-s;d=o<=0&&y>=0&&y<l?r(n[y]):d;let g=h+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=d&&a.push([d,p])}return a}function sg(n){return n==0?pg:n==1?En:e=>Rr(e,n)}function Bg(n){let e=n==0?ic:sc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=qi(c,a/2,l/2),u=qi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var ic=(n,e,t)=>{n.moveTo(e,t)},sc=(n,e,t)=>{n.moveTo(t,e)},Mo=(n,e,t)=>{n.lineTo(e,t)},wo=(n,e,t)=>{n.lineTo(t,e)},rc=Bg(0),Ff=Bg(1),kg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},zg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Gg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Vg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Hg(n){return(e,t,i,s,r)=>Nr(e,t,(o,a,l,c,u,f,h,d,p,y,_)=>{let{pxRound:g,points:b}=o,E,S;c.ori==0?(E=ic,S=kg):(E=sc,S=zg);let P=kt(b.width*At,3),C=(b.size-b.width)/2*At,v=kt(C*2,3),A=new Path2D,B=new Path2D,{left:N,top:L,width:k,height:V}=e.bbox;rc(B,N-v,L-v,k+v*2,V+v*2);let F=H=>{if(l[H]!=null){let Y=g(f(a[H],c,y,d)),G=g(h(l[H],u,_,p));E(A,Y+C,G),S(A,Y,G,C,0,$l*2)}};if(r)r.forEach(F);else for(let H=i;H<=s;H++)F(H);return{stroke:P>0?A:null,fill:A,clip:B,flags:bo|yf}})}function Wg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var jb=Wg(Mo),Qb=Wg(wo);function qg(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>Nr(t,i,(o,a,l,c,u,f,h,d,p,y,_)=>{[s,r]=jl(l,s,r);let g=o.pxRound,b=V=>g(f(V,c,y,d)),E=V=>g(h(V,u,_,p)),S,P;c.ori==0?(S=Mo,P=jb):(S=wo,P=Qb);let C=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:bo},A=v.stroke,B=!1;if(r-s>=y*4){let V=he=>t.posToVal(he,c.key,!0),F=null,H=null,Y,G,oe,Z=b(a[C==1?s:r]),Q=b(a[s]),se=b(a[r]),fe=V(C==1?Q+1:se-1);for(let he=C==1?s:r;he>=s&&he<=r;he+=C){let ee=a[he],ve=(C==1?ee<fe:ee>fe)?Z:b(ee),Ae=l[he];ve==Z?Ae!=null?(G=Ae,F==null?(S(A,ve,E(G)),Y=F=H=G):G<F?F=G:G>H&&(H=G)):Ae===null&&(B=!0):(F!=null&&P(A,Z,E(F),E(H),E(Y),E(G)),Ae!=null?(G=Ae,S(A,ve,E(G)),F=H=Y=G):(F=H=null,Ae===null&&(B=!0)),Z=ve,fe=V(Z+C))}F!=null&&F!=H&&oe!=Z&&P(A,Z,E(F),E(H),E(Y),E(G))}else for(let V=C==1?s:r;V>=s&&V<=r;V+=C){let F=l[V];F===null?B=!0:F!=null&&S(A,b(a[V]),E(F))}let[L,k]=Df(t,i);if(o.fill!=null||L!=0){let V=v.fill=new Path2D(A),F=o.fillTo(t,i,o.min,o.max,L),H=E(F),Y=b(a[s]),G=b(a[r]);C==-1&&([G,Y]=[Y,G]),S(V,G,H),S(V,Y,H)}if(!o.spanGaps){let V=[];B&&V.push(...Nf(a,l,s,r,C,b,e)),v.gaps=V=o.gaps(t,i,s,r,V),v.clip=nc(V,c.ori,d,p,y,_)}return k!=0&&(v.band=k==2?[Es(t,i,s,r,A,-1),Es(t,i,s,r,A,1)]:Es(t,i,s,r,A,k)),v})}function eS(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>Nr(r,o,(c,u,f,h,d,p,y,_,g,b,E)=>{[a,l]=jl(f,a,l);let S=c.pxRound,{left:P,width:C}=r.bbox,v=Q=>S(p(Q,h,b,_)),A=Q=>S(y(Q,d,E,g)),B=h.ori==0?Mo:wo,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:bo},L=N.stroke,k=h.dir*(h.ori==0?1:-1),V=A(f[k==1?a:l]),F=v(u[k==1?a:l]),H=F,Y=F;s&&e==-1&&(Y=P,B(L,Y,V)),B(L,F,V);for(let Q=k==1?a:l;Q>=a&&Q<=l;Q+=k){let se=f[Q];if(se==null)continue;let fe=v(u[Q]),he=A(se);e==1?B(L,fe,V):B(L,H,he),B(L,fe,he),V=he,H=fe}let G=H;s&&e==1&&(G=P+C,B(L,G,V));let[oe,Z]=Df(r,o);if(c.fill!=null||oe!=0){let Q=N.fill=new Path2D(L),se=c.fillTo(r,o,c.min,c.max,oe),fe=A(se);B(Q,G,fe),B(Q,Y,fe)}if(!c.spanGaps){let Q=[];Q.push(...Nf(u,f,a,l,k,v,i));let se=c.width*At/2,fe=t||e==1?se:-se,he=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=nc(Q,h.ori,_,g,b,E)}return Z!=0&&(N.band=Z==2?[Es(r,o,a,l,L,-1),Es(r,o,a,l,L,1)]:Es(r,o,a,l,L,Z)),N})}function rg(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=An(n[l]-n[a]);u<c&&(c=u,o=An(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function tS(n){n=n||Na;let e=wt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(n.disp,Na),u=wt(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,y,_)=>Nr(d,p,(g,b,E,S,P,C,v,A,B,N,L)=>{let k=g.pxRound,V=t,F=i*At,H=a*At,Y=l*At,G,oe;S.ori==0?[G,oe]=r(d,p):[oe,G]=r(d,p);let Z=S.dir*(S.ori==0?1:-1),Q=S.ori==0?rc:Ff,se=S.ori==0?u:(Re,Ze,at,Me,Ot,ze,Ye)=>{u(Re,Ze,at,Ot,Me,Ye,ze)},fe=wt(d.bands,Cf).find(Re=>Re.series[0]==p),he=fe!=null?fe.dir:0,ee=g.fillTo(d,p,g.min,g.max,he),me=k(v(ee,P,L,B)),ve,Ae,Se,We=N,ot=k(g.width*At),Ve=!1,ft=null,ct=null,st=null,Zt=null;f!=null&&(ot==0||h!=null)&&(Ve=!0,ft=f.values(d,p,y,_),ct=new Map,new Set(ft).forEach(Re=>{Re!=null&&ct.set(Re,new Path2D)}),ot>0&&(st=h.values(d,p,y,_),Zt=new Map,new Set(st).forEach(Re=>{Re!=null&&Zt.set(Re,new Path2D)})));let{x0:zt,size:dn}=c;if(zt!=null&&dn!=null){V=1,b=zt.values(d,p,y,_),zt.unit==2&&(b=b.map(at=>d.posToVal(A+at*N,S.key,!0)));let Re=dn.values(d,p,y,_);dn.unit==2?Ae=Re[0]*N:Ae=C(Re[0],S,N,A)-C(0,S,N,A),We=rg(b,E,C,S,N,A,We),Se=We-Ae+F}else We=rg(b,E,C,S,N,A,We),Se=We*o+F,Ae=We-Se;Se<1&&(Se=0),ot>=Ae/2&&(ot=0),Se<5&&(k=pg);let Ft=Se>0,In=We-Se-(Ft?ot:0);Ae=k(gf(In,Y,H)),ve=(V==0?Ae/2:V==Z?0:Ae)-V*Z*((V==0?F/2:0)+(Ft?ot/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Mn=Ve?null:new Path2D,nn=null;if(fe!=null)nn=d.data[fe.series[1]];else{let{y0:Re,y1:Ze}=c;Re!=null&&Ze!=null&&(E=Ze.values(d,p,y,_),nn=Re.values(d,p,y,_))}let pn=G*Ae,O=oe*Ae;for(let Re=Z==1?y:_;Re>=y&&Re<=_;Re+=Z){let Ze=E[Re];if(Ze==null)continue;if(nn!=null){let q=nn[Re]??0;if(Ze-q==0)continue;me=v(q,P,L,B)}let at=S.distr!=2||c!=null?b[Re]:Re,Me=C(at,S,N,A),Ot=v(wt(Ze,ee),P,L,B),ze=k(Me-ve),Ye=k(jn(Ot,me)),R=k(qi(Ot,me)),M=Ye-R;if(Ze!=null){let q=Ze<0?O:pn,ue=Ze<0?pn:O;Ve?(ot>0&&st[Re]!=null&&Q(Zt.get(st[Re]),ze,R+pi(ot/2),Ae,jn(0,M-ot),q,ue),ft[Re]!=null&&Q(ct.get(ft[Re]),ze,R+pi(ot/2),Ae,jn(0,M-ot),q,ue)):Q(Mn,ze,R+pi(ot/2),Ae,jn(0,M-ot),q,ue),se(d,p,Re,ze-ot/2,R,Ae+ot,M)}}return ot>0?bt.stroke=Ve?Zt:Mn:Ve||(bt._fill=g.width==0?g._fill:g._stroke??g._fill,bt.width=0),bt.fill=Ve?ct:Mn,bt})}function nS(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>Nr(i,s,(a,l,c,u,f,h,d,p,y,_,g)=>{[r,o]=jl(c,r,o);let b=a.pxRound,E=G=>b(h(G,u,_,p)),S=G=>b(d(G,f,g,y)),P,C,v;u.ori==0?(P=ic,v=Mo,C=Gg):(P=sc,v=wo,C=Vg);let A=u.dir*(u.ori==0?1:-1),B=E(l[A==1?r:o]),N=B,L=[],k=[];for(let G=A==1?r:o;G>=r&&G<=o;G+=A)if(c[G]!=null){let Z=l[G],Q=E(Z);L.push(N=Q),k.push(S(c[G]))}let V={stroke:n(L,k,P,v,C,b),fill:null,clip:null,band:null,gaps:null,flags:bo},F=V.stroke,[H,Y]=Df(i,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(F),oe=a.fillTo(i,s,a.min,a.max,H),Z=S(oe);v(G,N,Z),v(G,B,Z)}if(!a.spanGaps){let G=[];G.push(...Nf(l,c,r,o,A,E,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=nc(G,u.ori,p,y,_,g)}return Y!=0&&(V.band=Y==2?[Es(i,s,r,o,F,-1),Es(i,s,r,o,F,1)]:Es(i,s,r,o,F,Y)),V})}function iS(n){return nS(sS,n)}function sS(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var xf=new Set;function og(){for(let n of xf)n.syncRect(!0)}So&&(Lr(Bx,_o,og),Lr(kx,_o,og,!0),Lr(Zl,_o,()=>{Qt.pxRatio=At}));var rS=qg(),oS=Hg();function ag(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>bf(r,o,e,t))}function aS(n,e){return n.map((t,i)=>i==0?{}:bn({},e,t))}function bf(n,e,t,i){return bn({},e==0?t:i,n)}function Xg(n,e,t){return e==null?yo:[e,t]}var lS=Xg;function cS(n,e,t){return e==null?yo:Kl(e,t,Ef,!0)}function Yg(n,e,t,i){return e==null?yo:Ql(e,t,n.scales[i].log,!1)}var uS=Yg;function $g(n,e,t,i){return e==null?yo:Tf(e,t,n.scales[i].log,!1)}var hS=$g;function fS(n,e,t,i,s){let r=jn(km(n),km(e)),o=e-n,a=Wi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Js.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function lg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=En((t=+s)*At))+"px"),[n,e,t]}function dS(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Qt(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(x,w,I,D){let W=w.valToPct(x);return D+I*(w.dir==-1?1-W:W)}function o(x,w,I,D){let W=w.valToPct(x);return D+I*(w.dir==-1?W:1-W)}function a(x,w,I,D){return w.ori==0?r(x,w,I,D):o(x,w,I,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Li(xx);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let x=Li(Mx,c);x.textContent=n.title}let u=Hi("canvas"),f=i.ctx=u.getContext("2d"),h=Li(wx,c);Lr("click",h,x=>{x.target===p&&(Ht!=io||Kt!=so)&&Bn.click(i,x)},!0);let d=i.under=Li(Tx,h);h.appendChild(u);let p=i.over=Li(Ex,h);n=xo(n);let y=+wt(n.pxAlign,1),_=sg(y);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let g=n.ms||.001,b=i.series=s==1?ag(n.series||[],Jm,ng,!1):aS(n.series||[null],tg),E=i.axes=ag(n.axes||[],Km,Qm,!0),S=i.scales={},P=i.bands=n.bands||[];P.forEach(x=>{x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1)});let C=s==2?b[1].facets[0].scale:b[0].scale,v={axes:Ss,series:pt},A=(n.drawOrder||["axes","series"]).map(x=>v[x]);function B(x){let w=x.distr==3?I=>Ts(I>0?I:x.clamp(i,I,x.min,x.max,x.key)):x.distr==4?I=>lf(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let D=w(I),{_min:W,_max:J}=x,le=J-W;return(D-W)/le}}function N(x){let w=S[x];if(w==null){let I=(n.scales||Na)[x]||Na;if(I.from!=null){N(I.from);let D=bn({},S[I.from],I,{key:x});D.valToPct=B(D),S[x]=D}else{w=S[x]=bn({},x==C?Ug:Zb,I),w.key=x;let D=w.time,W=w.range,J=Ks(W);if((x!=C||s==2&&!D)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Um:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Um:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&tc(W))){let le=W;W=(de,xe,De)=>xe==null?yo:Kl(xe,De,le)}w.range=vt(W||(D?lS:x==C?w.distr==3?uS:w.distr==4?hS:Xg:w.distr==3?Yg:w.distr==4?$g:cS)),w.auto=vt(J?!1:w.auto),w.clamp=vt(w.clamp||$b),w._min=w._max=null,w.valToPct=B(w)}}}N("x"),N("y"),s==1&&b.forEach(x=>{N(x.scale)}),E.forEach(x=>{N(x.scale)});for(let x in n.scales)N(x);let L=S[C],k=L.distr,V,F;L.ori==0?(di(c,bx),V=r,F=o):(di(c,Sx),V=o,F=r);let H={};for(let x in S){let w=S[x];(w.min!=null||w.max!=null)&&(H[x]={min:w.min,max:w.max},w.min=w.max=null)}let Y=n.tzDate||(x=>new Date(En(x/g))),G=n.fmtDate||Rf,oe=g==1?bb(Y):wb(Y),Z=Ym(Y,Xm(g==1?xb:Mb,G)),Q=Zm(Y,$m(Eb,G)),se=[],fe=i.legend=bn({},Rb,n.legend),he=i.cursor=bn({},Fb,{drag:{y:s==2}},n.cursor),ee=fe.show,me=he.show,ve=fe.markers;fe.idxs=se,ve.width=vt(ve.width),ve.dash=vt(ve.dash),ve.stroke=vt(ve.stroke),ve.fill=vt(ve.fill);let Ae,Se,We,ot=[],Ve=[],ft,ct=!1,st={};if(fe.live){let x=b[1]?b[1].values:null;ct=x!=null,ft=ct?x(i,1,0):{_:0};for(let w in ft)st[w]=Mf}if(ee)if(Ae=Hi("table",Lx,c),We=Hi("tbody",null,Ae),fe.mount(i,Ae),ct){Se=Hi("thead",null,Ae,We);let x=Hi("tr",null,Se);Hi("th",null,x);for(var Zt in ft)Hi("th",Mm,x).textContent=Zt}else di(Ae,Nx),fe.live&&di(Ae,Dx);let zt={show:!0},dn={show:!1};function Ft(x,w){if(w==0&&(ct||!fe.live||s==2))return yo;let I=[],D=Hi("tr",Fx,We,We.childNodes[w]);di(D,x.class),x.show||di(D,Ir);let W=Hi("th",null,D);if(ve.show){let de=Li(Ux,W);if(w>0){let xe=ve.width(i,w);xe&&(de.style.border=xe+"px "+ve.dash(i,w)+" "+ve.stroke(i,w)),de.style.background=ve.fill(i,w)}}let J=Li(Mm,W);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,w>0&&(ve.show||(J.style.color=x.width>0?ve.stroke(i,w):ve.fill(i,w)),bt("click",W,de=>{if(he._lock)return;Je(de);let xe=b.indexOf(x);if((de.ctrlKey||de.metaKey)!=fe.isolate){let De=b.some((Ne,Ue)=>Ue>0&&Ue!=xe&&Ne.show);b.forEach((Ne,Ue)=>{Ue>0&&ss(Ue,De?Ue==xe?zt:dn:zt,!0,vn.setSeries)})}else ss(xe,{show:!x.show},!0,vn.setSeries)},!1),je&&bt(Am,W,de=>{he._lock||(Je(de),ss(b.indexOf(x),oo,!0,vn.setSeries))},!1));for(var le in ft){let de=Hi("td",Ox,D);de.textContent="--",I.push(de)}return[D,I]}let In=new Map;function bt(x,w,I,D=!0){let W=In.get(w)||{},J=he.bind[x](i,w,I,D);J&&(Lr(x,w,W[x]=J),In.set(w,W))}function Mn(x,w,I){let D=In.get(w)||{};for(let W in D)(x==null||W==x)&&(mf(W,w,D[W]),delete D[W]);x==null&&In.delete(w)}let nn=0,pn=0,O=0,Re=0,Ze=0,at=0,Me=Ze,Ot=at,ze=O,Ye=Re,R=0,M=0,q=0,ue=0;i.bbox={};let ae=!1,_e=!1,ye=!1,te=!1,ie=!1,pe=!1;function U(x,w,I){(I||x!=i.width||w!=i.height)&&re(x,w),ut(!1),ye=!0,_e=!0,Gn()}function re(x,w){i.width=nn=O=x,i.height=pn=Re=w,Ze=at=0,be(),He();let I=i.bbox;R=I.left=Rr(Ze*At,.5),M=I.top=Rr(at*At,.5),q=I.width=Rr(O*At,.5),ue=I.height=Rr(Re*At,.5)}let ne=3;function we(){let x=!1,w=0;for(;!x;){w++;let I=eo(w),D=is(w);x=w==ne||I&&D,x||(re(i.width,i.height),_e=!0)}}function ge({width:x,height:w}){U(x,w)}i.setSize=ge;function be(){let x=!1,w=!1,I=!1,D=!1;E.forEach((W,J)=>{if(W.show&&W._show){let{side:le,_size:de}=W,xe=le%2,De=W.label!=null?W.labelSize:0,Ne=de+De;Ne>0&&(xe?(O-=Ne,le==3?(Ze+=Ne,D=!0):I=!0):(Re-=Ne,le==0?(at+=Ne,x=!0):w=!0))}}),ts[0]=x,ts[1]=I,ts[2]=w,ts[3]=D,O-=Bi[1]+Bi[3],Ze+=Bi[3],Re-=Bi[2]+Bi[0],at+=Bi[0]}function He(){let x=Ze+O,w=at+Re,I=Ze,D=at;function W(J,le){switch(J){case 1:return x+=le,x-le;case 2:return w+=le,w-le;case 3:return I-=le,I+le;case 0:return D-=le,D+le}}E.forEach((J,le)=>{if(J.show&&J._show){let de=J.side;J._pos=W(de,J._size),J.label!=null&&(J._lpos=W(de,J.labelSize))}})}if(he.dataIdx==null){let x=he.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let I=x.prox=vt(x.prox),D=x.bias??=0;he.dataIdx=(W,J,le,de)=>{if(J==0)return le;let xe=le,De=I(W,J,le,de)??Bt,Ne=De>=0&&De<Bt,Ue=L.ori==0?O:Re,rt=he.left,Tt=e[0],Mt=e[J];if(w.has(Mt[le])){xe=null;let gt=null,Ke=null,qe;if(D==0||D==-1)for(qe=le;gt==null&&qe-- >0;)w.has(Mt[qe])||(gt=qe);if(D==0||D==1)for(qe=le;Ke==null&&qe++<Mt.length;)w.has(Mt[qe])||(Ke=qe);if(gt!=null||Ke!=null)if(Ne){let qt=gt==null?-1/0:V(Tt[gt],L,Ue,0),on=Ke==null?1/0:V(Tt[Ke],L,Ue,0),Fn=rt-qt,Ut=on-rt;Fn<=Ut?Fn<=De&&(xe=gt):Ut<=De&&(xe=Ke)}else xe=Ke==null?gt:gt==null?Ke:le-gt<=Ke-le?gt:Ke}else Ne&&An(rt-V(Tt[le],L,Ue,0))>De&&(xe=null);return xe}}let Je=x=>{he.event=x};he.idxs=se,he._lock=!1;let ce=he.points;ce.show=vt(ce.show),ce.size=vt(ce.size),ce.stroke=vt(ce.stroke),ce.width=vt(ce.width),ce.fill=vt(ce.fill);let Oe=i.focus=bn({},n.focus||{alpha:.3},he.focus),je=Oe.prox>=0,Ce=je&&ce.one,lt=[],Vt=[],Xn=[];function ua(x,w){let I=ce.show(i,w);if(I instanceof HTMLElement)return di(I,Ix),di(I,x.class),us(I,-10,-10,O,Re),p.insertBefore(I,lt[w]),I}function Jr(x,w){if(s==1||w>0){let I=s==1&&S[x.scale].time,D=x.value;x.value=I?Vm(D)?Zm(Y,$m(D,G)):D||Q:D||qb,x.label=x.label||(I?Ob:Ub)}if(Ce||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||rS||Zx,x.fillTo=vt(x.fillTo||Kb),x.pxAlign=+wt(x.pxAlign,y),x.pxRound=sg(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=Xb(jn(1,x.width),1),D=x.points=bn({},{size:I,width:jn(1,I*.2),stroke:x.stroke,space:I*2,paths:oS,_stroke:null,_fill:null},x.points);D.show=vt(D.show),D.filter=vt(D.filter),D.fill=vt(D.fill),D.stroke=vt(D.stroke),D.paths=vt(D.paths),D.pxAlign=x.pxAlign}if(ee){let I=Ft(x,w);ot.splice(w,0,I[0]),Ve.splice(w,0,I[1]),fe.values.push(null)}if(me){se.splice(w,0,null);let I=null;Ce?w==0&&(I=ua(x,w)):w>0&&(I=ua(x,w)),lt.splice(w,0,I),Vt.splice(w,0,0),Xn.splice(w,0,0)}Nn("addSeries",w)}function Ch(x,w){w=w??b.length,x=s==1?bf(x,w,Jm,ng):bf(x,w,{},tg),b.splice(w,0,x),Jr(b[w],w)}i.addSeries=Ch;function wl(x){if(b.splice(x,1),ee){fe.values.splice(x,1),Ve.splice(x,1);let w=ot.splice(x,1)[0];Mn(null,w.firstChild),w.remove()}me&&(se.splice(x,1),lt.splice(x,1)[0].remove(),Vt.splice(x,1),Xn.splice(x,1)),Nn("delSeries",x)}i.delSeries=wl;let ts=[!1,!1,!1,!1];function ys(x,w){if(x._show=x.show,x.show){let I=x.side%2,D=S[x.scale];D==null&&(x.scale=I?b[1].scale:C,D=S[x.scale]);let W=D.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),Ks(x.incrs)&&x.incrs.forEach(le=>{!Js.has(le)&&Js.set(le,_g(le))}),x.incrs=vt(x.incrs||(D.distr==2?_b:W?g==1?yb:Sb:Pr)),x.splits=vt(x.splits||(W&&D.distr==1?oe:D.distr==3?_f:D.distr==4?zb:kb)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let J=x.values;x.values=Ks(J)&&!Ks(J[0])?vt(J):W?Ks(J)?Ym(Y,Xm(J,G)):Vm(J)?Tb(Y,J):J||Z:J||Bb,x.filter=vt(x.filter||(D.distr>=3&&D.log==10?Hb:D.distr==3&&D.log==2?Wb:mg)),x.font=lg(x.font),x.labelFont=lg(x.labelFont),x._size=x.size(i,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(ts[w]=!0,x._el=Li(Ax,h))}}function xs(x,w,I,D){let[W,J,le,de]=I,xe=w%2,De=0;return xe==0&&(de||J)&&(De=w==0&&!W||w==2&&!le?En(Km.size/3):0),xe==1&&(W||le)&&(De=w==1&&!J||w==3&&!de?En(Qm.size/2):0),De}let ha=i.padding=(n.padding||[xs,xs,xs,xs]).map(x=>vt(wt(x,xs))),Bi=i._padding=ha.map((x,w)=>x(i,w,ts,0)),sn,cn=null,un=null,ns=s==1?b[0].idxs:null,ci=null,Gs=!1;function fa(x,w){if(e=x??[],i.data=i._data=e,s==2){sn=0;for(let I=1;I<b.length;I++)sn+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ci=e[0],sn=ci.length;let I=e;if(k==2){I=e.slice();let D=I[0]=Array(sn);for(let W=0;W<sn;W++)D[W]=W}i._data=e=I}if(ut(!0),Nn("setData"),k==2&&(ye=!0),w!==!1){let I=L;I.auto(i,Gs)?da():Ws(C,I.min,I.max),te=te||he.left>=0,pe=!0,Gn()}}i.setData=fa;function da(){Gs=!0;let x,w;s==1&&(sn>0?(cn=ns[0]=0,un=ns[1]=sn-1,x=e[0][cn],w=e[0][un],k==2?(x=cn,w=un):x==w&&(k==3?[x,w]=Ql(x,x,L.log,!1):k==4?[x,w]=Tf(x,x,L.log,!1):L.time?w=x+En(86400/g):[x,w]=Kl(x,w,Ef,!0))):(cn=ns[0]=x=null,un=ns[1]=w=null)),Ws(C,x,w)}let jr,Vs,Qr,T,z,j,X,$,Te,Pe;function Ee(x,w,I,D,W,J){x??=Tm,I??=Cf,D??="butt",W??=Tm,J??="round",x!=jr&&(f.strokeStyle=jr=x),W!=Vs&&(f.fillStyle=Vs=W),w!=Qr&&(f.lineWidth=Qr=w),J!=z&&(f.lineJoin=z=J),D!=j&&(f.lineCap=j=D),I!=T&&f.setLineDash(T=I)}function Ie(x,w,I,D){w!=Vs&&(f.fillStyle=Vs=w),x!=X&&(f.font=X=x),I!=$&&(f.textAlign=$=I),D!=Te&&(f.textBaseline=Te=D)}function ke(x,w,I,D,W=0){if(D.length>0&&x.auto(i,Gs)&&(w==null||w.min==null)){let J=wt(cn,0),le=wt(un,D.length-1),de=I.min==null?Hx(D,J,le,W,x.distr==3):[I.min,I.max];x.min=qi(x.min,I.min=de[0]),x.max=jn(x.max,I.max=de[1])}}let tt={min:null,max:null};function dt(){for(let D in S){let W=S[D];H[D]==null&&(W.min==null||H[C]!=null&&W.auto(i,Gs))&&(H[D]=tt)}for(let D in S){let W=S[D];H[D]==null&&W.from!=null&&H[W.from]!=null&&(H[D]=tt)}H[C]!=null&&ut(!0);let x={};for(let D in H){let W=H[D];if(W!=null){let J=x[D]=xo(S[D],jx);if(W.min!=null)bn(J,W);else if(D!=C||s==2)if(sn==0&&J.from==null){let le=J.range(i,null,null,D);J.min=le[0],J.max=le[1]}else J.min=Bt,J.max=-Bt}}if(sn>0){b.forEach((D,W)=>{if(s==1){let J=D.scale,le=H[J];if(le==null)return;let de=x[J];if(W==0){let xe=de.range(i,de.min,de.max,J);de.min=xe[0],de.max=xe[1],cn=Wi(de.min,e[0]),un=Wi(de.max,e[0]),un-cn>1&&(e[0][cn]<de.min&&cn++,e[0][un]>de.max&&un--),D.min=ci[cn],D.max=ci[un]}else D.show&&D.auto&&ke(de,le,D,e[W],D.sorted);D.idxs[0]=cn,D.idxs[1]=un}else if(W>0&&D.show&&D.auto){let[J,le]=D.facets,de=J.scale,xe=le.scale,[De,Ne]=e[W],Ue=x[de],rt=x[xe];Ue!=null&&ke(Ue,H[de],J,De,J.sorted),rt!=null&&ke(rt,H[xe],le,Ne,le.sorted),D.min=le.min,D.max=le.max}});for(let D in x){let W=x[D],J=H[D];if(W.from==null&&(J==null||J.min==null)){let le=W.range(i,W.min==Bt?null:W.min,W.max==-Bt?null:W.max,D);W.min=le[0],W.max=le[1]}}}for(let D in x){let W=x[D];if(W.from!=null){let J=x[W.from];if(J.min==null)W.min=W.max=null;else{let le=W.range(i,J.min,J.max,D);W.min=le[0],W.max=le[1]}}}let w={},I=!1;for(let D in x){let W=x[D],J=S[D];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let le=J.distr;J._min=le==3?Ts(J.min):le==4?lf(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?Ts(J.max):le==4?lf(J.max,J.asinh):le==100?J.fwd(J.max):J.max,w[D]=I=!0}}if(I){b.forEach((D,W)=>{s==2?W>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)ye=!0,Nn("setScale",D);me&&he.left>=0&&(te=pe=!0)}for(let D in H)H[D]=null}function Be(x){let w=gf(cn-1,0,sn-1),I=gf(un+1,0,sn-1);for(;x[w]==null&&w>0;)w--;for(;x[I]==null&&I<sn-1;)I++;return[w,I]}function pt(){if(sn>0){let x=b.some(w=>w._focus)&&Pe!=Oe.alpha;x&&(f.globalAlpha=Pe=Oe.alpha),b.forEach((w,I)=>{if(I>0&&w.show&&(jt(I,!1),jt(I,!0),w._paths==null)){let D=Pe;Pe!=w.alpha&&(f.globalAlpha=Pe=w.alpha);let W=s==2?[0,e[I][0].length-1]:Be(e[I]);w._paths=w.paths(i,I,W[0],W[1]),Pe!=D&&(f.globalAlpha=Pe=D)}}),b.forEach((w,I)=>{if(I>0&&w.show){let D=Pe;Pe!=w.alpha&&(f.globalAlpha=Pe=w.alpha),w._paths!=null&&It(I,!1);{let W=w._paths!=null?w._paths.gaps:null,J=w.points.show(i,I,cn,un,W),le=w.points.filter(i,I,J,W);(J||le)&&(w.points._paths=w.points.paths(i,I,cn,un,le),It(I,!0))}Pe!=D&&(f.globalAlpha=Pe=D),Nn("drawSeries",I)}}),x&&(f.globalAlpha=Pe=1)}}function jt(x,w){let I=w?b[x].points:b[x];I._stroke=I.stroke(i,x),I._fill=I.fill(i,x)}function It(x,w){let I=w?b[x].points:b[x],{stroke:D,fill:W,clip:J,flags:le,_stroke:de=I._stroke,_fill:xe=I._fill,_width:De=I.width}=I._paths;De=kt(De*At,3);let Ne=null,Ue=De%2/2;w&&xe==null&&(xe=De>0?"#fff":de);let rt=I.pxAlign==1&&Ue>0;if(rt&&f.translate(Ue,Ue),!w){let Tt=R-De/2,Mt=M-De/2,gt=q+De,Ke=ue+De;Ne=new Path2D,Ne.rect(Tt,Mt,gt,Ke)}w?Fe(de,De,I.dash,I.cap,xe,D,W,le,J):Lt(x,de,De,I.dash,I.cap,xe,D,W,le,Ne,J),rt&&f.translate(-Ue,-Ue)}function Lt(x,w,I,D,W,J,le,de,xe,De,Ne){let Ue=!1;xe!=0&&P.forEach((rt,Tt)=>{if(rt.series[0]==x){let Mt=b[rt.series[1]],gt=e[rt.series[1]],Ke=(Mt._paths||Na).band;Ks(Ke)&&(Ke=rt.dir==1?Ke[0]:Ke[1]);let qe,qt=null;Mt.show&&Ke&&qx(gt,cn,un)?(qt=rt.fill(i,Tt)||J,qe=Mt._paths.clip):Ke=null,Fe(w,I,D,W,qt,le,de,xe,De,Ne,qe,Ke),Ue=!0}}),Ue||Fe(w,I,D,W,J,le,de,xe,De,Ne)}let wn=bo|yf;function Fe(x,w,I,D,W,J,le,de,xe,De,Ne,Ue){Ee(x,w,I,D,W),(xe||De||Ue)&&(f.save(),xe&&f.clip(xe),De&&f.clip(De)),Ue?(de&wn)==wn?(f.clip(Ue),Ne&&f.clip(Ne),_t(W,le),mn(x,J,w)):de&yf?(_t(W,le),f.clip(Ue),mn(x,J,w)):de&bo&&(f.save(),f.clip(Ue),Ne&&f.clip(Ne),_t(W,le),f.restore(),mn(x,J,w)):(_t(W,le),mn(x,J,w)),(xe||De||Ue)&&f.restore()}function mn(x,w,I){I>0&&(w instanceof Map?w.forEach((D,W)=>{f.strokeStyle=jr=W,f.stroke(D)}):w!=null&&x&&f.stroke(w))}function _t(x,w){w instanceof Map?w.forEach((I,D)=>{f.fillStyle=Vs=D,f.fill(I)}):w!=null&&x&&f.fill(w)}function bs(x,w,I,D){let W=E[x],J;if(D<=0)J=[0,0];else{let le=W._space=W.space(i,x,w,I,D),de=W._incrs=W.incrs(i,x,w,I,D,le);J=fS(w,I,de,D,le)}return W._found=J}function gn(x,w,I,D,W,J,le,de,xe,De){let Ne=le%2/2;y==1&&f.translate(Ne,Ne),Ee(de,le,xe,De,de),f.beginPath();let Ue,rt,Tt,Mt,gt=W+(D==0||D==3?-J:J);I==0?(rt=W,Mt=gt):(Ue=W,Tt=gt);for(let Ke=0;Ke<x.length;Ke++)w[Ke]!=null&&(I==0?Ue=Tt=x[Ke]:rt=Mt=x[Ke],f.moveTo(Ue,rt),f.lineTo(Tt,Mt));f.stroke(),y==1&&f.translate(-Ne,-Ne)}function eo(x){let w=!0;return E.forEach((I,D)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,ut(!1));return}else I._show||(w=!1,I._show=!0,ut(!1));let J=I.side,le=J%2,{min:de,max:xe}=W,[De,Ne]=bs(D,de,xe,le==0?O:Re);if(Ne==0)return;let Ue=W.distr==2,rt=I._splits=I.splits(i,D,de,xe,De,Ne,Ue),Tt=W.distr==2?rt.map(qe=>ci[qe]):rt,Mt=W.distr==2?ci[rt[1]]-ci[rt[0]]:De,gt=I._values=I.values(i,I.filter(i,Tt,D,Ne,Mt),D,Ne,Mt);I._rotate=J==2?I.rotate(i,gt,D,Ne):0;let Ke=I._size;I._size=Di(I.size(i,gt,D,x)),Ke!=null&&I._size!=Ke&&(w=!1)}),w}function is(x){let w=!0;return ha.forEach((I,D)=>{let W=I(i,D,ts,x);W!=Bi[D]&&(w=!1),Bi[D]=W}),w}function Ss(){for(let x=0;x<E.length;x++){let w=E[x];if(!w.show||!w._show)continue;let I=w.side,D=I%2,W,J,le=w.stroke(i,x),de=I==0||I==3?-1:1,[xe,De]=w._found;if(w.label!=null){let Zn=w.labelGap*de,fi=En((w._lpos+Zn)*At);Ie(w.labelFont[0],le,"center",I==2?"top":wm),f.save(),D==1?(W=J=0,f.translate(fi,En(M+ue/2)),f.rotate((I==3?-$l:$l)/2)):(W=En(R+q/2),J=fi);let wr=dg(w.label)?w.label(i,x,xe,De):w.label;f.fillText(wr,W,J),f.restore()}if(De==0)continue;let Ne=S[w.scale],Ue=D==0?q:ue,rt=D==0?R:M,Tt=w._splits,Mt=Ne.distr==2?Tt.map(Zn=>ci[Zn]):Tt,gt=Ne.distr==2?ci[Tt[1]]-ci[Tt[0]]:xe,Ke=w.ticks,qe=w.border,qt=Ke.show?Ke.size:0,on=En(qt*At),Fn=En((w.alignTo==2?w._size-qt-w.gap:w.gap)*At),Ut=w._rotate*-$l/180,an=_(w._pos*At),ui=(on+Fn)*de,$n=an+ui;J=D==0?$n:0,W=D==1?$n:0;let Ei=w.font[0],ki=w.align==1?mo:w.align==2?rf:Ut>0?mo:Ut<0?rf:D==0?"center":I==3?rf:mo,os=Ut||D==1?"middle":I==2?"top":wm;Ie(Ei,le,ki,os);let hi=w.font[1]*w.lineGap,Ai=Tt.map(Zn=>_(a(Zn,Ne,Ue,rt))),zi=w._values;for(let Zn=0;Zn<zi.length;Zn++){let fi=zi[Zn];if(fi!=null){D==0?W=Ai[Zn]:J=Ai[Zn],fi=""+fi;let wr=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let Kn=0;Kn<wr.length;Kn++){let kp=wr[Kn];Ut?(f.save(),f.translate(W,J+Kn*hi),f.rotate(Ut),f.fillText(kp,0,0),f.restore()):f.fillText(kp,W,J+Kn*hi)}}}Ke.show&&gn(Ai,Ke.filter(i,Mt,x,De,gt),D,I,an,on,kt(Ke.width*At,3),Ke.stroke(i,x),Ke.dash,Ke.cap);let as=w.grid;as.show&&gn(Ai,as.filter(i,Mt,x,De,gt),D,D==0?2:1,D==0?M:R,D==0?ue:q,kt(as.width*At,3),as.stroke(i,x),as.dash,as.cap),qe.show&&gn([an],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:q,kt(qe.width*At,3),qe.stroke(i,x),qe.dash,qe.cap)}Nn("drawAxes")}function ut(x){b.forEach((w,I)=>{I>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let rn=!1,Yn=!1,Dt=[];function _n(){Yn=!1;for(let x=0;x<Dt.length;x++)Nn(...Dt[x]);Dt.length=0}function Gn(){rn||(rb(bp),rn=!0)}function Tl(x,w=!1){rn=!0,Yn=w,x(i),bp(),w&&Dt.length>0&&queueMicrotask(_n)}i.batch=Tl;function bp(){if(ae&&(dt(),ae=!1),ye&&(we(),ye=!1),_e){if(Yt(d,mo,Ze),Yt(d,"top",at),Yt(d,Pa,O),Yt(d,Ia,Re),Yt(p,mo,Ze),Yt(p,"top",at),Yt(p,Pa,O),Yt(p,Ia,Re),Yt(h,Pa,nn),Yt(h,Ia,pn),u.width=En(nn*At),u.height=En(pn*At),E.forEach(({_el:x,_show:w,_size:I,_pos:D,side:W})=>{if(x!=null)if(w){let J=W===3||W===0?I:0,le=W%2==1;Yt(x,le?"left":"top",D-J),Yt(x,le?"width":"height",I),Yt(x,le?"top":"left",le?at:Ze),Yt(x,le?"height":"width",le?Re:O),pf(x,Ir)}else di(x,Ir)}),jr=Vs=Qr=z=j=X=$=Te=T=null,Pe=1,ga(!0),Ze!=Me||at!=Ot||O!=ze||Re!=Ye){ut(!1);let x=O/ze,w=Re/Ye;if(me&&!te&&he.left>=0){he.left*=x,he.top*=w,to&&us(to,En(he.left),0,O,Re),no&&us(no,0,En(he.top),O,Re);for(let I=0;I<lt.length;I++){let D=lt[I];D!=null&&(Vt[I]*=x,Xn[I]*=w,us(D,Di(Vt[I]),Di(Xn[I]),O,Re))}}if(Wt.show&&!ie&&Wt.left>=0&&Wt.width>0){Wt.left*=x,Wt.width*=x,Wt.top*=w,Wt.height*=w;for(let I in Nh)Yt(ro,I,Wt[I])}Me=Ze,Ot=at,ze=O,Ye=Re}Nn("setSize"),_e=!1}nn>0&&pn>0&&(f.clearRect(0,0,u.width,u.height),Nn("drawClear"),A.forEach(x=>x()),Nn("draw")),Wt.show&&ie&&(El(Wt),ie=!1),me&&te&&(Mr(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(Lh(),pe=!1),l||(l=!0,i.status=1,Nn("ready")),Gs=!1,rn=!1}i.redraw=(x,w)=>{ye=w||!1,x!==!1?Ws(C,L.min,L.max):Gn()};function Rh(x,w){let I=S[x];if(I.from==null){if(sn==0){let D=I.range(i,w.min,w.max,x);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(sn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==C&&I.distr==2&&sn>0&&(w.min=Wi(w.min,e[0]),w.max=Wi(w.max,e[0]),w.min==w.max&&w.max++),H[x]=w,ae=!0,Gn()}}i.setScale=Rh;let Ph,Ih,to,no,Sp,Mp,io,so,wp,Tp,Ht,Kt,Hs=!1,Bn=he.drag,Ln=Bn.x,Dn=Bn.y;me&&(he.x&&(Ph=Li(Rx,p)),he.y&&(Ih=Li(Px,p)),L.ori==0?(to=Ph,no=Ih):(to=Ih,no=Ph),Ht=he.left,Kt=he.top);let Wt=i.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ro=Wt.show?Li(Cx,Wt.over?p:d):null;function El(x,w){if(Wt.show){for(let I in x)Wt[I]=x[I],I in Nh&&Yt(ro,I,x[I]);w!==!1&&Nn("setSelect")}}i.setSelect=El;function Ty(x){if(b[x].show)ee&&pf(ot[x],Ir);else if(ee&&di(ot[x],Ir),me){let I=Ce?lt[0]:lt[x];I!=null&&us(I,-10,-10,O,Re)}}function Ws(x,w,I){Rh(x,{min:w,max:I})}function ss(x,w,I,D){w.focus!=null&&Py(x),w.show!=null&&b.forEach((W,J)=>{J>0&&(x==J||x==null)&&(W.show=w.show,Ty(J),s==2?(Ws(W.facets[0].scale,null,null),Ws(W.facets[1].scale,null,null)):Ws(W.scale,null,null),Gn())}),I!==!1&&Nn("setSeries",x,w),D&&_a("setSeries",i,x,w)}i.setSeries=ss;function Ey(x,w){bn(P[x],w)}function Ay(x,w){x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1),w=w??P.length,P.splice(w,0,x)}function Cy(x){x==null?P.length=0:P.splice(x,1)}i.addBand=Ay,i.setBand=Ey,i.delBand=Cy;function Ry(x,w){b[x].alpha=w,me&&lt[x]!=null&&(lt[x].style.opacity=w),ee&&ot[x]&&(ot[x].style.opacity=w)}let Ms,qs,Sr,oo={focus:!0};function Py(x){if(x!=Sr){let w=x==null,I=Oe.alpha!=1;b.forEach((D,W)=>{if(s==1||W>0){let J=w||W==0||W==x;D._focus=w?null:J,I&&Ry(W,J?1:Oe.alpha)}}),Sr=x,I&&Gn()}}ee&&je&&bt(Cm,Ae,x=>{he._lock||(Je(x),Sr!=null&&ss(null,oo,!0,vn.setSeries))});function rs(x,w,I){let D=S[w];I&&(x=x/At-(D.ori==1?at:Ze));let W=O;D.ori==1&&(W=Re,x=W-x),D.dir==-1&&(x=W-x);let J=D._min,le=D._max,de=x/W,xe=J+(le-J)*de,De=D.distr;return De==3?vo(10,xe):De==4?Yx(xe,D.asinh):De==100?D.bwd(xe):xe}function Iy(x,w){let I=rs(x,C,w);return Wi(I,e[0],cn,un)}i.valToIdx=x=>Wi(x,e[0]),i.posToIdx=Iy,i.posToVal=rs,i.valToPos=(x,w,I)=>S[w].ori==0?r(x,S[w],I?q:O,I?R:0):o(x,S[w],I?ue:Re,I?M:0),i.setCursor=(x,w,I)=>{Ht=x.left,Kt=x.top,Mr(null,w,I)};function Ep(x,w){Yt(ro,mo,Wt.left=x),Yt(ro,Pa,Wt.width=w)}function Ap(x,w){Yt(ro,"top",Wt.top=x),Yt(ro,Ia,Wt.height=w)}let pa=L.ori==0?Ep:Ap,ma=L.ori==1?Ep:Ap;function Ly(){if(ee&&fe.live)for(let x=s==2?1:0;x<b.length;x++){if(x==0&&ct)continue;let w=fe.values[x],I=0;for(let D in w)Ve[x][I++].firstChild.nodeValue=w[D]}}function Lh(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((I,D)=>{se[D]=I}):Jx(x.idx)||se.fill(x.idx),fe.idx=se[0]),ee&&fe.live){for(let I=0;I<b.length;I++)(I>0||s==1&&!ct)&&Dy(I,se[I]);Ly()}pe=!1,w!==!1&&Nn("setLegend")}i.setLegend=Lh;function Dy(x,w){let I=b[x],D=x==0&&k==2?ci:e[x],W;ct?W=I.values(i,x,w)??st:(W=I.value(i,w==null?null:D[w],x,w),W=W==null?st:{_:W}),fe.values[x]=W}function Mr(x,w,I){wp=Ht,Tp=Kt,[Ht,Kt]=he.move(i,Ht,Kt),he.left=Ht,he.top=Kt,me&&(to&&us(to,En(Ht),0,O,Re),no&&us(no,0,En(Kt),O,Re));let D,W=cn>un;Ms=Bt,qs=null;let J=L.ori==0?O:Re,le=L.ori==1?O:Re;if(Ht<0||sn==0||W){D=he.idx=null;for(let de=0;de<b.length;de++){let xe=lt[de];xe!=null&&us(xe,-10,-10,O,Re)}je&&ss(null,oo,!0,x==null&&vn.setSeries),fe.live&&(se.fill(D),pe=!0)}else{let de,xe,De;s==1&&(de=L.ori==0?Ht:Kt,xe=rs(de,C),D=he.idx=Wi(xe,e[0],cn,un),De=V(e[0][D],L,J,0));let Ne=-10,Ue=-10,rt=0,Tt=0,Mt=!0,gt="",Ke="";for(let qe=s==2?1:0;qe<b.length;qe++){let qt=b[qe],on=se[qe],Fn=on==null?null:s==1?e[qe][on]:e[qe][1][on],Ut=he.dataIdx(i,qe,D,xe),an=Ut==null?null:s==1?e[qe][Ut]:e[qe][1][Ut];if(pe=pe||an!=Fn||Ut!=on,se[qe]=Ut,qe>0&&qt.show){let ui=Ut==null?-10:Ut==D?De:V(s==1?e[0][Ut]:e[qe][0][Ut],L,J,0),$n=an==null?-10:F(an,s==1?S[qt.scale]:S[qt.facets[1].scale],le,0);if(je&&an!=null){let Ei=L.ori==1?Ht:Kt,ki=An(Oe.dist(i,qe,Ut,$n,Ei));if(ki<Ms){let os=Oe.bias;if(os!=0){let hi=rs(Ei,qt.scale),Ai=an>=0?1:-1,zi=hi>=0?1:-1;zi==Ai&&(zi==1?os==1?an>=hi:an<=hi:os==1?an<=hi:an>=hi)&&(Ms=ki,qs=qe)}else Ms=ki,qs=qe}}if(pe||Ce){let Ei,ki;L.ori==0?(Ei=ui,ki=$n):(Ei=$n,ki=ui);let os,hi,Ai,zi,as,Zn,fi=!0,wr=ce.bbox;if(wr!=null){fi=!1;let Kn=wr(i,qe);Ai=Kn.left,zi=Kn.top,os=Kn.width,hi=Kn.height}else Ai=Ei,zi=ki,os=hi=ce.size(i,qe);if(Zn=ce.fill(i,qe),as=ce.stroke(i,qe),Ce)qe==qs&&Ms<=Oe.prox&&(Ne=Ai,Ue=zi,rt=os,Tt=hi,Mt=fi,gt=Zn,Ke=as);else{let Kn=lt[qe];Kn!=null&&(Vt[qe]=Ai,Xn[qe]=zi,Fm(Kn,os,hi,fi),Dm(Kn,Zn,as),us(Kn,Di(Ai),Di(zi),O,Re))}}}}if(Ce){let qe=Oe.prox,qt=Sr==null?Ms<=qe:Ms>qe||qs!=Sr;if(pe||qt){let on=lt[0];on!=null&&(Vt[0]=Ne,Xn[0]=Ue,Fm(on,rt,Tt,Mt),Dm(on,gt,Ke),us(on,Di(Ne),Di(Ue),O,Re))}}}if(Wt.show&&Hs)if(x!=null){let[de,xe]=vn.scales,[De,Ne]=vn.match,[Ue,rt]=x.cursor.sync.scales,Tt=x.cursor.drag;if(Ln=Tt._x,Dn=Tt._y,Ln||Dn){let{left:Mt,top:gt,width:Ke,height:qe}=x.select,qt=x.scales[Ue].ori,on=x.posToVal,Fn,Ut,an,ui,$n,Ei=de!=null&&De(de,Ue),ki=xe!=null&&Ne(xe,rt);Ei&&Ln?(qt==0?(Fn=Mt,Ut=Ke):(Fn=gt,Ut=qe),an=S[de],ui=V(on(Fn,Ue),an,J,0),$n=V(on(Fn+Ut,Ue),an,J,0),pa(qi(ui,$n),An($n-ui))):pa(0,J),ki&&Dn?(qt==1?(Fn=Mt,Ut=Ke):(Fn=gt,Ut=qe),an=S[xe],ui=F(on(Fn,rt),an,le,0),$n=F(on(Fn+Ut,rt),an,le,0),ma(qi(ui,$n),An($n-ui))):ma(0,le)}else Fh()}else{let de=An(wp-Sp),xe=An(Tp-Mp);if(L.ori==1){let rt=de;de=xe,xe=rt}Ln=Bn.x&&de>=Bn.dist,Dn=Bn.y&&xe>=Bn.dist;let De=Bn.uni;De!=null?Ln&&Dn&&(Ln=de>=De,Dn=xe>=De,!Ln&&!Dn&&(xe>de?Dn=!0:Ln=!0)):Bn.x&&Bn.y&&(Ln||Dn)&&(Ln=Dn=!0);let Ne,Ue;Ln&&(L.ori==0?(Ne=io,Ue=Ht):(Ne=so,Ue=Kt),pa(qi(Ne,Ue),An(Ue-Ne)),Dn||ma(0,le)),Dn&&(L.ori==1?(Ne=io,Ue=Ht):(Ne=so,Ue=Kt),ma(qi(Ne,Ue),An(Ue-Ne)),Ln||pa(0,J)),!Ln&&!Dn&&(pa(0,0),ma(0,0))}if(Bn._x=Ln,Bn._y=Dn,x==null){if(I){if(Bp!=null){let[de,xe]=vn.scales;vn.values[0]=de!=null?rs(L.ori==0?Ht:Kt,de):null,vn.values[1]=xe!=null?rs(L.ori==1?Ht:Kt,xe):null}_a(of,i,Ht,Kt,O,Re,D)}if(je){let de=I&&vn.setSeries,xe=Oe.prox;Sr==null?Ms<=xe&&ss(qs,oo,!0,de):Ms>xe?ss(null,oo,!0,de):qs!=Sr&&ss(qs,oo,!0,de)}}pe&&(fe.idx=D,Lh()),w!==!1&&Nn("setCursor")}let Xs=null;Object.defineProperty(i,"rect",{get(){return Xs==null&&ga(!1),Xs}});function ga(x=!1){x?Xs=null:(Xs=p.getBoundingClientRect(),Nn("syncRect",Xs))}function Cp(x,w,I,D,W,J,le){he._lock||Hs&&x!=null&&x.movementX==0&&x.movementY==0||(Dh(x,w,I,D,W,J,le,!1,x!=null),x!=null?Mr(null,!0,!0):Mr(w,!0,!1))}function Dh(x,w,I,D,W,J,le,de,xe){if(Xs==null&&ga(!1),Je(x),x!=null)I=x.clientX-Xs.left,D=x.clientY-Xs.top;else{if(I<0||D<0){Ht=-10,Kt=-10;return}let[De,Ne]=vn.scales,Ue=w.cursor.sync,[rt,Tt]=Ue.values,[Mt,gt]=Ue.scales,[Ke,qe]=vn.match,qt=w.axes[0].side%2==1,on=L.ori==0?O:Re,Fn=L.ori==1?O:Re,Ut=qt?J:W,an=qt?W:J,ui=qt?D:I,$n=qt?I:D;if(Mt!=null?I=Ke(De,Mt)?a(rt,S[De],on,0):-10:I=on*(ui/Ut),gt!=null?D=qe(Ne,gt)?a(Tt,S[Ne],Fn,0):-10:D=Fn*($n/an),L.ori==1){let Ei=I;I=D,D=Ei}}xe&&(w==null||w.cursor.event.type==of)&&((I<=1||I>=O-1)&&(I=Rr(I,O)),(D<=1||D>=Re-1)&&(D=Rr(D,Re))),de?(Sp=I,Mp=D,[io,so]=he.move(i,I,D)):(Ht=I,Kt=D)}let Nh={width:0,height:0,left:0,top:0};function Fh(){El(Nh,!1)}let Rp,Pp,Ip,Lp;function Dp(x,w,I,D,W,J,le){Hs=!0,Ln=Dn=Bn._x=Bn._y=!1,Dh(x,w,I,D,W,J,le,!0,!1),x!=null&&(bt(af,ff,Np,!1),_a(Em,i,io,so,O,Re,null));let{left:de,top:xe,width:De,height:Ne}=Wt;Rp=de,Pp=xe,Ip=De,Lp=Ne}function Np(x,w,I,D,W,J,le){Hs=Bn._x=Bn._y=!1,Dh(x,w,I,D,W,J,le,!1,!0);let{left:de,top:xe,width:De,height:Ne}=Wt,Ue=De>0||Ne>0,rt=Rp!=de||Pp!=xe||Ip!=De||Lp!=Ne;if(Ue&&rt&&El(Wt),Bn.setScale&&Ue&&rt){let Tt=de,Mt=De,gt=xe,Ke=Ne;if(L.ori==1&&(Tt=xe,Mt=Ne,gt=de,Ke=De),Ln&&Ws(C,rs(Tt,C),rs(Tt+Mt,C)),Dn)for(let qe in S){let qt=S[qe];qe!=C&&qt.from==null&&qt.min!=Bt&&Ws(qe,rs(gt+Ke,qe),rs(gt,qe))}Fh()}else he.lock&&(he._lock=!he._lock,Mr(w,!0,x!=null));x!=null&&(Mn(af,ff),_a(af,i,Ht,Kt,O,Re,null))}function Ny(x,w,I,D,W,J,le){if(he._lock)return;Je(x);let de=Hs;if(Hs){let xe=!0,De=!0,Ne=10,Ue,rt;L.ori==0?(Ue=Ln,rt=Dn):(Ue=Dn,rt=Ln),Ue&&rt&&(xe=Ht<=Ne||Ht>=O-Ne,De=Kt<=Ne||Kt>=Re-Ne),Ue&&xe&&(Ht=Ht<io?0:O),rt&&De&&(Kt=Kt<so?0:Re),Mr(null,!0,!0),Hs=!1}Ht=-10,Kt=-10,se.fill(null),Mr(null,!0,!0),de&&(Hs=de)}function Fp(x,w,I,D,W,J,le){he._lock||(Je(x),da(),Fh(),x!=null&&_a(Rm,i,Ht,Kt,O,Re,null))}function Up(){E.forEach(dS),U(i.width,i.height,!0)}Lr(Zl,_o,Up);let ao={};ao.mousedown=Dp,ao.mousemove=Cp,ao.mouseup=Np,ao.dblclick=Fp,ao.setSeries=(x,w,I,D)=>{let W=vn.match[2];I=W(i,w,I),I!=-1&&ss(I,D,!0,!1)},me&&(bt(Em,p,Dp),bt(of,p,Cp),bt(Am,p,x=>{Je(x),ga(!1)}),bt(Cm,p,Ny),bt(Rm,p,Fp),xf.add(i),i.syncRect=ga);let Al=i.hooks=n.hooks||{};function Nn(x,w,I){Yn?Dt.push([x,w,I]):x in Al&&Al[x].forEach(D=>{D.call(null,i,w,I)})}(n.plugins||[]).forEach(x=>{for(let w in x.hooks)Al[w]=(Al[w]||[]).concat(x.hooks[w])});let Op=(x,w,I)=>I,vn=bn({key:null,setSeries:!1,filters:{pub:zm,sub:zm},scales:[C,b[1]?b[1].scale:null],match:[Gm,Gm,Op],values:[null,null]},he.sync);vn.match.length==2&&vn.match.push(Op),he.sync=vn;let Bp=vn.key,Uh=Og(Bp);function _a(x,w,I,D,W,J,le){vn.filters.pub(x,w,I,D,W,J,le)&&Uh.pub(x,w,I,D,W,J,le)}Uh.sub(i);function Fy(x,w,I,D,W,J,le){vn.filters.sub(x,w,I,D,W,J,le)&&ao[x](null,w,I,D,W,J,le)}i.pub=Fy;function Uy(){Uh.unsub(i),xf.delete(i),In.clear(),mf(Zl,_o,Up),c.remove(),Ae?.remove(),Nn("destroy")}i.destroy=Uy;function Oh(){Nn("init",n,e),fa(e||n.data,!1),H[C]?Rh(C,H[C]):da(),ie=Wt.show&&(Wt.width>0||Wt.height>0),te=pe=!0,U(n.width,n.height)}return b.forEach(Jr),E.forEach(ys),t?t instanceof HTMLElement?(t.appendChild(c),Oh()):t(i,Oh):Oh(),i}Qt.assign=bn;Qt.fmtNum=Af;Qt.rangeNum=Kl;Qt.rangeLog=Ql;Qt.rangeAsinh=Tf;Qt.orient=Nr;Qt.pxRatio=At;Qt.join=sb;Qt.fmtDate=Rf,Qt.tzDate=mb;Qt.sync=Og;{Qt.addGap=Jb,Qt.clipGaps=nc;let n=Qt.paths={points:Hg};n.linear=qg,n.stepped=eS,n.bars=tS,n.spline=iS}function Qe(n){let e=document.querySelector(".haptonic")??document.documentElement;return getComputedStyle(e).getPropertyValue(`--${n}`).trim()}function si(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}function js(n,e,t,i=[]){let{ctx:s,bbox:r}=n,o=n.valToPos(e,"x",!0);o<r.left||o>r.left+r.width||Qs(s,[o,r.top],[o,r.top+r.height],t,i)}function To(n,e,t,i=[]){let{ctx:s,bbox:r}=n,o=n.valToPos(e,"y",!0);Qs(s,[r.left,o],[r.left+r.width,o],t,i)}function Qs(n,e,t,i,s=[]){n.save(),n.strokeStyle=Qe(i),n.lineWidth=1.5*devicePixelRatio,n.setLineDash(s.map(r=>r*devicePixelRatio)),n.beginPath(),n.moveTo(...e),n.lineTo(...t),n.stroke(),n.restore()}function As(n,[e,t],i,s=5){n.save(),n.setLineDash([]),n.beginPath(),n.arc(e,t,s*devicePixelRatio,0,2*Math.PI),n.fillStyle=Qe(i),n.strokeStyle=Qe("paper"),n.lineWidth=2*devicePixelRatio,n.fill(),n.stroke(),n.restore()}function Fr(n,[e,t],i){let{ctx:s,bbox:r}=n,[o,a]=[n.valToPos(e,"x",!0),n.valToPos(t,"x",!0)];s.fillStyle=Qe(i),s.fillRect(o,r.top,a-o,r.height)}var pS=240;function er(n){return Math.max(n.clientWidth,pS)}function tr(n,e,t,i){let s=[...i,si(()=>n.redraw(!1,!0))],r=new ResizeObserver(()=>n.setSize(t()));return r.observe(e),()=>{r.disconnect();for(let o of s)o();n.destroy()}}function Eo(n,e){n.over.addEventListener("click",({clientX:t,clientY:i})=>{let s=n.over.getBoundingClientRect();e(t-s.left,i-s.top)})}function nr({ctx:n,bbox:e},t){n.save(),n.beginPath(),n.rect(e.left,e.top,e.width,e.height),n.clip(),t(),n.restore()}var oc=class{constructor(e){this.data=e;this.distance=e.values("distance"),this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),[this.rows=0,this.bands=0]=e.shape("frequency"),this.names=e.parsed("character_names");let t=e.parsed("path_labels"),i=e.parsed("path_corners");this.corners=t.map((r,o)=>({label:r,row:i[o]??0}));let s=e.header.attrs.carrier_hz;this.carrier=typeof s=="number"?s:void 0,this.top=Number(e.header.extra.top),this.units=Ci(e),this.pitch=Uf(e),this.wavevectorUnits=fo(this.pitch),this.gaps=Of(e)}data;distance;frequency;error;rows;bands;gaps;corners;carrier;top;units;pitch;wavevectorUnits;names;branches(){let e=this.data.values("branch"),t=new Map;return e.forEach((i,s)=>{let r=t.get(i)??Array(this.rows).fill(null);r[Math.floor(s/this.bands)]=this.frequency[s]??null,t.set(i,r)}),[...t.values()]}at({row:e,band:t}){return this.frequency[e*this.bands+t]??NaN}errorAt({row:e,band:t}){return this.error[e*this.bands+t]??NaN}nature({row:e,band:t}){return this.motion(this.data.values("character")[e*this.bands+t])}motion(e){return this.names[e??-1]??""}parity({row:e,band:t}){let i=e*this.bands+t;return Bf(this.data.values("parity")[i],"the mirror of the path",this.data.values("middle_parity")[i])}velocity({row:e,band:t}){let i=this.data.values("group_velocity"),s=2*(e*this.bands+t),[r,o]=[i[s]??NaN,i[s+1]??NaN];return Number.isFinite(r)&&Number.isFinite(o)?[r,o]:void 0}velocityError({row:e,band:t}){return this.data.has("group_velocity_error")?this.data.values("group_velocity_error")[e*this.bands+t]:void 0}phases(e){let t=this.data.values("kappa");return[t[2*e]??0,t[2*e+1]??0]}place(e){let t=this.corners.find(a=>a.row===e);if(t!==void 0)return t.label;let i=this.corners.findIndex(a=>a.row>e),[s,r]=[this.corners[i-1],this.corners[i]];if(s===void 0||r===void 0)return"";let o=(e-s.row)/(r.row-s.row);return`${Number(o.toFixed(3))} of ${s.label}-${r.label}`}belowGap(e){let t=e.below-1,i=0;for(let s=1;s<this.rows;s++)this.at({row:s,band:t})>this.at({row:i,band:t})&&(i=s);return{row:i,band:t}}},Uf=n=>Number(n.header.attrs.pitch_m);function Of(n){if(!n.has("gap_below"))return[];let e=t=>n.values(t);return Array.from(e("gap_below"),(t,i)=>({below:t,lower:e("gap_lower")[i]??NaN,upper:e("gap_upper")[i]??NaN,lowerError:e("gap_lower_error")[i]??NaN,upperError:e("gap_upper_error")[i]??NaN,complete:e("gap_complete")[i]===1,direction:n.texts("gap_direction")[i]??"",waves:n.texts("gap_waves")[i]??""}))}function Bf(n,e,t){let i=["even","odd"][Zg(n)],s=["symmetric","antisymmetric"][Zg(t)];return[i&&`${i} under ${e}`,s&&`${s} about the plate's middle plane`].filter(Boolean).join(", ")}function Zg(n){return n===1?0:n===-1?1:-1}var mS=.2,gS=.1;function _S({data:n,at:e}){if(n===null)return null;if(e!==null)return vS(n,e);let[t,i]=[n.values("frequency"),n.values("frequency_error")],[s,r]=[n.values("distance"),Uf(n)];return{isPreview:!1,distance:s,pitch:r,frequency:t,error:i,gaps:Of(n)}}function Kg(n){let e=xn(()=>n?.value?_S(n.value):null);return{layer:e,isWaiting:xn(()=>!!n?.value&&e.value===null)}}var ac=({distance:n,pitch:e,frequency:t,error:i,gaps:s})=>({isPreview:!1,distance:n,pitch:e,frequency:t,error:i,gaps:s});function vS(n,e){let t=n.values("value"),i=t.length-1;if(e<(t[0]??NaN)*(1-1e-9)||e>(t[i]??NaN)*(1+1e-9))return null;let s=Math.max(1,t.findIndex(C=>C>=e)),[r,o]=[t[s-1]??0,t[s]??1],a=o-r,l=Math.min(Math.max((e-r)/a,0),1),c=C=>{let v=n.values(C).length/t.length,A=G=>{let oe=n.values(G);return[oe.subarray((s-1)*v,s*v),oe.subarray(s*v,(s+1)*v)]},[[B,N],[L,k],[V,F]]=[A(C),A(`${C}_error`),A(`${C}_bend`)],H=(G,oe,Z)=>(1-l)*(G[Z]??NaN)+l*(oe[Z]??NaN),Y=a*l*(1-l);return[Float64Array.from(B,(G,oe)=>H(B,N,oe)),Float64Array.from(B,(G,oe)=>H(L,k,oe)+Y*((V[oe]??NaN)+(F[oe]??NaN)))]},[u,f]=c("frequency"),h=gS*Math.max(...u);if(u.some((C,v)=>!((f[v]??NaN)<=mS*Math.max(C,h))))return null;let[d,p]=c("edge"),y=d.length/2,_=Array.from({length:y},(C,v)=>({below:v+1,lower:d[v]??NaN,upper:d[y+v]??NaN,lowerError:p[v]??NaN,upperError:p[y+v]??NaN,complete:!0,direction:"all",waves:"all"})),g=(C,v)=>{let A=n.values(C),B=A.length/t.length;return[A[(s-1)*B+v]??NaN,A[s*B+v]??NaN]},b=Float64Array.from({length:n.values("distance").length/t.length},(C,v)=>{let[A,B]=g("distance",v);return A===0?0:1/((1-l)/A+l/B)}),[E,S]=g("pitch",0),P=(1-l)*E+l*S;return{isPreview:!0,distance:b,pitch:P,frequency:u,error:f,gaps:_.filter(({lower:C,upper:v})=>v>C)}}var yS={preview:{colour:"accent",dash:[5,3],width:1.6},certified:{colour:"ink",dash:[],width:1.6},held:{colour:"curve-1",dash:[1.5,3],width:1.5}};function kf(n,e,t,i,s,r){let{ctx:o}=n,{colour:a,dash:l,width:c}=yS[r],u=Array.from(t.distance,d=>n.valToPos(d/s,"x",!0)),f=(d,p)=>{let y=(t.frequency[d]??NaN)+p*(t.error[d]??NaN);return n.valToPos(y/i,"y",!0)},h=(d,p,y=!1)=>{for(let _=0;_<e.rows;_++){let g=y?e.rows-1-_:_;o.lineTo(u[g]??0,f(g*e.bands+d,p))}};o.save(),o.fillStyle=o.strokeStyle=Qe(a),o.lineWidth=c*devicePixelRatio,o.setLineDash(l.map(d=>d*devicePixelRatio));for(let d=0;d<e.bands;d++)r==="preview"&&(o.globalAlpha=.2,o.beginPath(),h(d,1),h(d,-1,!0),o.fill(),o.globalAlpha=1),o.beginPath(),h(d,0),o.stroke();if(r==="held")for(let d of t.gaps.filter(({complete:p})=>p))for(let p of[d.lower,d.upper]){let y=n.valToPos(p/i,"y",!0);o.beginPath(),o.moveTo(n.bbox.left,y),o.lineTo(n.bbox.left+n.bbox.width,y),o.stroke()}o.restore()}var xS=340,bS=.72,SS=40;function Jg({diagram:n,choice:e,newer:t}){let i=Nt(null);return Gi(()=>{let s=i.current;if(s!==null)return MS(s,n,e,t)},[n,e,t]),m("div",{class:"curves",ref:i})}function MS(n,e,t,{layer:i,isWaiting:s}){let r=()=>t.unit.peek().factor,o=ac(e),a=()=>i.peek()??o,l=b=>jg(t,b).factor,c=b=>(b.distance[e.rows-1]??1)/l(b),u=e.branches(),f=()=>[Array.from(e.distance,b=>b/l(o)),...u.map(b=>b.map(E=>E===null?null:E/r()))],h=()=>{let b=er(n);return{width:b,height:Math.max(xS,Math.min(bS*b,.7*innerHeight))}},d=()=>{let b=a();return e.corners.map(({row:E})=>(b.distance[E]??0)/l(b))},p={stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")},grid:{}},y=new Qt({...h(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(b,E,S)=>[E,S]},y:{range:(b,E,S)=>E===null?[0,1]:[E<.2*S?0:E,S]}},axes:[{...p,splits:d,values:()=>d().map((b,E)=>`${e.corners[E]?.label}
${Number(b.toPrecision(3))}`),font:"14px system-ui, sans-serif",size:56,label:"wavevector",labelFont:"14px system-ui, sans-serif",labelSize:22,grid:{stroke:()=>Qe("rule"),width:1}},{...p,size:48,font:"13px system-ui, sans-serif",grid:{show:!1},label:"frequency",labelFont:"14px system-ui, sans-serif",labelSize:24,values:(b,E)=>E.map(S=>`${Number(S.toPrecision(6))}`)}],series:[{},...u.map(()=>({stroke:()=>i.peek()!==null?"transparent":Qe(s.peek()?"rule":"ink"),width:1.6,points:{show:!1}}))],hooks:{drawClear:[b=>nr(b,()=>{let E=t.held.peek(),S=s.peek()?[]:(i.peek()??e).gaps;TS(b,S,e.carrier,r()),E!==null&&kf(b,e,E.layer,r(),l(E.layer),"held")})],draw:[b=>{let E=i.peek();E!==null&&nr(b,()=>kf(b,e,E,r(),l(E),E.isPreview?"preview":"certified")),AS(b,e,t,a())}]}},f(),n),_=()=>y.setScale("y",{min:0,max:e.top/r()}),g=()=>{let b=t.held.peek();y.setScale("x",{min:0,max:Math.max(c(a()),b===null?0:c(b.layer))})};return _(),Eo(y,(b,E)=>{let S=wS(y,e,r(),l(o),b,E);S!==void 0&&(t.point.value=S)}),Object.assign(n,{plot:y}),tr(y,n,h,[Et(()=>{let[b,E]=y.axes;b!==void 0&&(b.label=Xt("length of the path",t.wavevectorUnit.value)),E!==void 0&&(E.label=Xt("frequency",t.unit.value)),y.setData(f(),!0),_(),g()}),Et(()=>{i.value,t.held.value,g()}),Et(()=>{let b=e.at(t.point.value)/r();i.value,s.value,t.held.value,b>(y.scales.y?.max??1/0)?y.setScale("y",{min:0,max:1.03*b}):y.redraw(!1,!1)})])}function jg(n,{pitch:e}){let t=n.wavevectorUnit.peek();return fo(e).find(({name:i})=>i===t.name)??t}function wS(n,e,t,i,s,r){let[o,a]=[void 0,SS];for(let l=0;l<e.rows;l++){let c=n.valToPos((e.distance[l]??0)/i,"x")-s;if(!(Math.abs(c)>a))for(let u=0;u<e.bands;u++){let f=Math.hypot(c,n.valToPos(e.at({row:l,band:u})/t,"y")-r);f<a&&([o,a]=[{row:l,band:u},f])}}return o}function TS(n,e,t,i){let{ctx:s,bbox:r}=n;for(let o of e){let a=n.valToPos(o.upper/i,"y",!0),l=n.valToPos(o.lower/i,"y",!0)-a;o.complete?(s.fillStyle=Qe("gap"),s.fillRect(r.left,a,r.width,l)):o.waves!=="all"&&ES(s,r.left,a,r.width,l)}t!==void 0&&To(n,t/i,"carrier",[7,5])}function ES(n,e,t,i,s){let r=12*devicePixelRatio;n.save(),n.beginPath(),n.rect(e,t,i,s),n.clip(),n.beginPath();for(let o=e-s;o<e+i;o+=r)n.moveTo(o,t+s),n.lineTo(o+s,t);n.strokeStyle=Qe("gap"),n.lineWidth=2*devicePixelRatio,n.stroke(),n.restore()}function AS(n,e,t,i){let s=t.point.peek(),r=n.valToPos((i.distance[s.row]??0)/jg(t,i).factor,"x",!0),o=i.frequency[s.row*e.bands+s.band]??NaN,a=n.valToPos(o/t.unit.peek().factor,"y",!0);As(n.ctx,[r,a],"accent",6)}function Qg(n,e){let t=i=>e===void 0?i.upper-i.lower:e_(i,e).room;return n.filter(({complete:i})=>i).sort((i,s)=>t(s)-t(i))[0]}function e_(n,e){let[t,i]=[e-n.lower,n.upper-e];return t<i?{room:t,error:n.lowerError}:{room:i,error:n.upperError}}function t_(n,e,t){let i=Qg(n,e),{factor:s}=t,r=(l,c)=>Gt(l/s,c/s),o=(l,c)=>kn(r(l,c),t);if(i===void 0)return{gap:"none complete below the last band"};let a=e===void 0?void 0:e_(i,e);return{gap:kn(`${r(i.lower,i.lowerError)} to ${r(i.upper,i.upperError)}`,t),width:o(i.upper-i.lower,i.lowerError+i.upperError),...a&&e!==void 0?{[`margin at ${kn(ls(e/s),t)}`]:o(a.room,a.error)}:{}}}function n_({gaps:n,carrier:e,unit:t}){let i=Qg(n,e),s=i!==void 0&&i.upper-i.lower>i.lowerError+i.upperError;return m("dl",{class:"edges",children:[Object.entries(t_(n,e,t)).map(([r,o])=>m("div",{children:[m("dt",{children:r}),m("dd",{children:o})]})),i!==void 0&&!s&&m("div",{children:[m("dt",{children:"narrower than its errors"}),m("dd",{children:"may be closed"})]})]})}function i_({held:n,now:e,unit:t,isPreview:i,drop:s}){let r=({gaps:l,carrier:c})=>t_(l,c,t),a=[...Object.keys(e.design).filter(l=>e.design[l]!==n.design[l]).map(l=>[l,n.design[l]??"",e.design[l]??""]),...[...new Set([...Object.keys(r(n)),...Object.keys(r(e))])].map(l=>[l,r(n)[l]??"",r(e)[l]??""])];return m("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Held design and this one",children:[m("table",{children:[m("caption",{children:"Held design and this one"}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"quantity"}),m("th",{scope:"col",children:"held"}),m("th",{scope:"col",children:i?"preview":"this design"})]})}),m("tbody",{children:a.map(([l,c,u])=>m("tr",{children:[m("th",{scope:"row",children:l}),m("td",{children:c}),m("td",{children:u})]}))})]}),m("button",{type:"button",onClick:s,children:"Let go of the held design"})]})}function CS(){return matchMedia("(prefers-reduced-motion: reduce)").matches}var hs=()=>({playing:Xe(!CS()),pace:Xe(.7)}),ir=class{constructor({playing:e,pace:t},i,...s){this.draw=i;for(let a of s)this.seen.observe(a);let r=0,o=a=>{r>0&&(this.moment=(this.moment+(a-r)/1e3*t.peek())%1),r=a,!document.hidden&&this.hidden.size<s.length&&i(),this.frame=requestAnimationFrame(o)};this.stop=Et(()=>{cancelAnimationFrame(this.frame),r=0,e.value&&(this.frame=requestAnimationFrame(o))})}draw;moment=0;frame=0;stop;hidden=new Set;seen=new IntersectionObserver(e=>{for(let{target:t,isIntersecting:i}of e)i?this.hidden.delete(t):this.hidden.add(t)});at(e){this.moment=e,this.draw()}end(){cancelAnimationFrame(this.frame),this.seen.disconnect(),this.stop()}};var lc=6,cc=.5;function s_(n){let e=n.gaps[0];return{point:Xe(e?n.belowGap(e):{row:n.corners[1]?.row??0,band:0}),...hs(),swing:Xe(.15),copies:Xe([2,2]),unit:Xe(Ri(n.units,Math.max(...n.frequency))),wavevectorUnit:Xe(n.wavevectorUnits[1]),listing:Xe("none"),held:Xe(null)}}function uc(n,{row:e,band:t},i,s){return{row:Math.min(Math.max(e+i,0),n.rows-1),band:Math.min(Math.max(t+s,0),n.bands-1)}}function r_(n,{band:e}){let t=[...n.gaps].filter(s=>s.waves==="all").sort((s,r)=>s.below-r.below),i=t.find(s=>s.below-1>e)??t[0];return i&&n.belowGap(i)}var RS=10,o_=.05;function a_(n,e,t){let i=(o,a)=>e.point.value=uc(n,e.point.value,o,a),s=o=>e.swing.value=Math.min(Math.max(e.swing.value+o,0),cc),r=o=>o.shiftKey?RS:1;return[{keys:"← →",effect:"previous or next wavevector; ten with Shift",actions:{ArrowLeft:o=>i(-r(o),0),ArrowRight:o=>i(r(o),0)}},{keys:"↑ ↓",effect:"next higher or lower band",actions:{ArrowUp:()=>i(0,1),ArrowDown:()=>i(0,-1)}},cs(e),{keys:"+ −",effect:"larger or smaller displacement",actions:{"+":()=>s(o_),"-":()=>s(-o_)}},{keys:"g",effect:"lower edge of the next gap",actions:{g:()=>e.point.value=r_(n,e.point.value)??e.point.value}},...t?[{keys:"h",effect:"hold this design, or let it go",actions:{h:t}}]:[],...ni(e.listing)]}var Ao=Wy(x_(),1);function b_(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),6e4)}var pc=40,mc=40,Wf="video/webm",JS=6,S_=new WeakMap;function Co(n,e){S_.set(n,e)}function Ro({canvas:n,name:e,caption:t}){let[i,s]=Zs(""),r=typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported(Wf),o=(a,l)=>async()=>{if(n.current!==null){s(`The ${a} is made.`),await new Promise(c=>setTimeout(c,mc));try{b_(await l(new qf(n.current,t)),`${e}.${a.toLowerCase()}`),s("")}catch(c){s(`The ${a} cannot be made: ${String(c)}`)}}};return m("p",{class:"sides film",children:[m("span",{children:"Save the motion"}),m("button",{type:"button",onClick:()=>{o("GIF",jS)()},children:"GIF"}),r&&m("button",{type:"button",onClick:()=>{o("WebM",QS)()},children:"WebM"}),m("span",{role:"status",children:i})]})}var qf=class{constructor(e,t){this.canvas=e;this.caption=t;let i=S_.get(e),s=this.copy.getContext("2d",{willReadFrequently:!0});if(i===void 0||s===null)throw new Error("the canvas does not move");[this.draw,this.context]=[i,s],[this.copy.width,this.copy.height]=[e.width,e.height]}canvas;caption;copy=document.createElement("canvas");context;draw;show(e){let{context:t,copy:i}=this;this.draw(e),t.fillStyle=Qe("panel"),t.fillRect(0,0,i.width,i.height),t.drawImage(this.canvas,0,0),t.font=`${13*devicePixelRatio}px system-ui, sans-serif`,t.fillStyle=Qe("ink");let s=JS*devicePixelRatio;return t.fillText(this.caption,s,i.height-s,i.width-2*s),t}};async function jS(n){let{width:e,height:t}=n.copy,i=(0,Ao.GIFEncoder)(),s;for(let r=0;r<pc;r++){let{data:o}=n.show(r/pc).getImageData(0,0,e,t);s??=(0,Ao.quantize)(o,256),i.writeFrame((0,Ao.applyPalette)(o,s),e,t,r===0?{palette:s,delay:mc}:{delay:mc}),r%5===4&&await new Promise(a=>setTimeout(a))}return i.finish(),new Blob([i.bytes()],{type:"image/gif"})}async function QS(n){n.show(0);let e=n.copy.captureStream(),t=new MediaRecorder(e,{mimeType:Wf,videoBitsPerSecond:8e6}),i=[];t.ondataavailable=({data:r})=>i.push(r);let s=new Promise(r=>t.onstop=r);t.start();for(let r=0;r<pc;r++)n.show(r/pc),await new Promise(o=>setTimeout(o,mc));t.stop(),await s;for(let r of e.getTracks())r.stop();return new Blob(i,{type:Wf})}var gr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},_r={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Z_=0,vd=1,K_=2;var cl=1,J_=2,ea=3,vr=0,ti=1,Oi=2,qr=0,ta=1,yd=2,xd=3,bd=4,j_=5;var Xr=100,Q_=101,e0=102,t0=103,n0=104,i0=200,s0=201,r0=202,o0=203,Sd=204,Md=205,a0=206,l0=207,c0=208,u0=209,h0=210,f0=211,d0=212,p0=213,m0=214,zc=0,Gc=1,Vc=2,Wo=3,Hc=4,Wc=5,qc=6,Xc=7,wd=0,g0=1,_0=2,gs=0,Td=1,Ed=2,Ad=3,Cd=4,Rd=5,Pd=6,Id=7;var Ld=300,Yr=301,na=302,xu=303,bu=304,Yc=1e3,ds=1001,$c=1002,On=1003,v0=1004;var ul=1005;var zn=1006,Su=1007;var Os=1008;var Ti=1009,Dd=1010,Nd=1011,ia=1012,Mu=1013,Ki=1014,Ji=1015,ji=1016,wu=1017,Tu=1018,$r=1020,Fd=35902,Ud=35899,Od=1021,Bd=1022,Qi=1023,Ns=1026,Bs=1027,kd=1028,Eu=1029,yr=1030,Au=1031;var Cu=1033,hl=33776,fl=33777,dl=33778,pl=33779,Ru=35840,Pu=35841,Iu=35842,Lu=35843,Du=36196,Nu=37492,Fu=37496,Uu=37488,Ou=37489,ml=37490,Bu=37491,ku=37808,zu=37809,Gu=37810,Vu=37811,Hu=37812,Wu=37813,qu=37814,Xu=37815,Yu=37816,$u=37817,Zu=37818,Ku=37819,Ju=37820,ju=37821,Qu=36492,eh=36494,th=36495,nh=36283,ih=36284,gl=36285,sh=36286;var qa=2300,Zc=2301,Bc=2302,fd=2303,dd=2400,pd=2401,md=2402;var y0=3200;var zd=0,x0=1,ks="",vi="srgb",Xa="srgb-linear",Ya="linear",Pt="srgb";var kc=7680;var b0=519,S0=512,M0=513,w0=514,Gd=515,T0=516,E0=517,Vd=518,Hd=519,A0=35044;var Wd="300 es",Fi=2e3,$a=2001;function eM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function tM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Za(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function C0(){let n=Za("canvas");return n.style.display="block",n}var M_={},qo=null;function qd(...n){let e="THREE."+n.shift();qo?qo("log",e,...n):console.log(e,...n)}function R0(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $e(...n){n=R0(n);let e="THREE."+n.shift();if(qo)qo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function nt(...n){n=R0(n);let e="THREE."+n.shift();if(qo)qo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Va(...n){let e=n.join(" ");e in M_||(M_[e]=!0,$e(...n))}function P0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var I0={[zc]:zc,[Vc]:qc,[Hc]:Hc,[Wo]:Wc,[Gc]:Gc,[qc]:Vc,[Xc]:Xc,[Wc]:Wo},Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],w_=1234567,Ha=Math.PI/180,Xo=180/Math.PI;function sa(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]).toLowerCase()}function mt(n,e,t){return Math.max(e,Math.min(t,n))}function Xd(n,e){return(n%e+e)%e}function nM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function iM(n,e,t){return n!==e?(t-n)/(e-n):0}function Wa(n,e,t){return(1-t)*n+t*e}function sM(n,e,t,i){return Wa(n,e,1-Math.exp(-t*i))}function rM(n,e=1){return e-Math.abs(Xd(n,e*2)-e)}function oM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function aM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function lM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function cM(n,e){return n+Math.random()*(e-n)}function uM(n){return n*(.5-Math.random())}function hM(n){n!==void 0&&(w_=n);let e=w_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function fM(n){return n*Ha}function dM(n){return n*Xo}function pM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function mM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Yd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function gM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function $d(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function L0(n,e){if(e.constructor===Float32Array)return n;let t=$d(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function D0(n,e){if(e.constructor===Float32Array)return n;let t=$d(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Zd={DEG2RAD:Ha,RAD2DEG:Xo,generateUUID:sa,clamp:mt,euclideanModulo:Xd,mapLinear:nM,inverseLerp:iM,lerp:Wa,damp:sM,pingpong:rM,smoothstep:oM,smootherstep:aM,randInt:lM,randFloat:cM,randFloatSpread:uM,seededRandom:hM,degToRad:fM,radToDeg:dM,isPowerOfTwo:pM,ceilPowerOfTwo:mM,floorPowerOfTwo:Yd,setQuaternionFromProperEuler:gM,normalize:D0,denormalize:L0},it=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},xi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],y=r[o+3];if(f!==y||l!==h||c!==d||u!==p){let _=l*h+c*d+u*p+f*y;_<0&&(h=-h,d=-d,p=-p,y=-y,_=-_);let g=1-a;if(_<.9995){let b=Math.acos(_),E=Math.sin(b);g=Math.sin(g*b)/E,a=Math.sin(a*b)/E,l=l*g+h*a,c=c*g+d*a,u=u*g+p*a,f=f*g+y*a}else{l=l*g+h*a,c=c*g+d*a,u=u*g+p*a,f=f*g+y*a;let b=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=b,c*=b,u*=b,f*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(T_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(T_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Xf.copy(this).projectOnVector(e),this.sub(Xf)}reflect(e){return this.sub(Xf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Xf=new K,T_=new xi,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],y=s[0],_=s[3],g=s[6],b=s[1],E=s[4],S=s[7],P=s[2],C=s[5],v=s[8];return r[0]=o*y+a*b+l*P,r[3]=o*_+a*E+l*C,r[6]=o*g+a*S+l*v,r[1]=c*y+u*b+f*P,r[4]=c*_+u*E+f*C,r[7]=c*g+u*S+f*v,r[2]=h*y+d*b+p*P,r[5]=h*_+d*E+p*C,r[8]=h*g+d*S+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return e[0]=f*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=h*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=d*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Va("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Yf.makeScale(e,t)),this}rotate(e){return Va("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Yf.makeRotation(-e)),this}translate(e,t){return Va("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Yf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Yf=new et,E_=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),A_=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _M(){let n={enabled:!0,workingColorSpace:Xa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Ds(s.r),s.g=Ds(s.g),s.b=Ds(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=Ho(s.r),s.g=Ho(s.g),s.b=Ho(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ks?Ya:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Xa]:{primaries:e,whitePoint:i,transfer:Ya,toXYZ:E_,fromXYZ:A_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:vi},outputColorSpaceConfig:{drawingBufferColorSpace:vi}},[vi]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:E_,fromXYZ:A_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:vi}}}),n}var yt=_M();function Ds(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ho(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Po,Kc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Po===void 0&&(Po=Za("canvas")),Po.width=e.width,Po.height=e.height;let s=Po.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Po}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Za("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ds(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Ds(t[i]/255)*255):t[i]=Ds(t[i]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},vM=0,Yo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:vM++}),this.uuid=sa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push($f(s[o].image)):r.push($f(s[o]))}else r=$f(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function $f(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Kc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var yM=0,Zf=new K,oi=class n extends Zi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ds,s=ds,r=zn,o=Os,a=Qi,l=Ti,c=n.DEFAULT_ANISOTROPY,u=ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:yM++}),this.uuid=sa(),this.name="",this.source=new Yo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Zf).x}get height(){return this.source.getSize(Zf).y}get depth(){return this.source.getSize(Zf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Ld)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Yc:e.x=e.x-Math.floor(e.x);break;case ds:e.x=e.x<0?0:1;break;case $c:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Yc:e.y=e.y-Math.floor(e.y);break;case ds:e.y=e.y<0?0:1;break;case $c:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=Ld;oi.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],y=l[2],_=l[6],g=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-y)<.01&&Math.abs(p-_)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+y)<.1&&Math.abs(p+_)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,S=(d+1)/2,P=(g+1)/2,C=(u+h)/4,v=(f+y)/4,A=(p+_)/4;return E>S&&E>P?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=C/i,r=v/i):S>P?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=C/s,r=A/s):P<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),i=v/r,s=A/r),this.set(i,s,r,t),this}let b=Math.sqrt((_-p)*(_-p)+(f-y)*(f-y)+(h-u)*(h-u));return Math.abs(b)<.001&&(b=1),this.x=(_-p)/b,this.y=(f-y)/b,this.z=(h-u)/b,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Jc=class extends Zi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new oi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:zn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Yo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bi=class extends Jc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ka=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var jc=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var en=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,_)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,_){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=f,g[14]=h,g[3]=d,g[7]=p,g[11]=y,g[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Io.setFromMatrixColumn(e,0).length(),r=1/Io.setFromMatrixColumn(e,1).length(),o=1/Io.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,y=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-y*c,t[9]=-a*l,t[2]=y-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,y=c*f;t[0]=h+y*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=y+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,y=c*f;t[0]=h-y*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=y-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,y=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+y,t[1]=l*f,t[5]=y*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=y-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-y*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+y,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=y*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(xM,e,bM)}lookAt(e,t,i){let s=this.elements;return gi.subVectors(e,t),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),rr.crossVectors(i,gi),rr.lengthSq()===0&&(Math.abs(i.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),rr.crossVectors(i,gi)),rr.normalize(),gc.crossVectors(gi,rr),s[0]=rr.x,s[4]=gc.x,s[8]=gi.x,s[1]=rr.y,s[5]=gc.y,s[9]=gi.y,s[2]=rr.z,s[6]=gc.z,s[10]=gi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],y=i[6],_=i[10],g=i[14],b=i[3],E=i[7],S=i[11],P=i[15],C=s[0],v=s[4],A=s[8],B=s[12],N=s[1],L=s[5],k=s[9],V=s[13],F=s[2],H=s[6],Y=s[10],G=s[14],oe=s[3],Z=s[7],Q=s[11],se=s[15];return r[0]=o*C+a*N+l*F+c*oe,r[4]=o*v+a*L+l*H+c*Z,r[8]=o*A+a*k+l*Y+c*Q,r[12]=o*B+a*V+l*G+c*se,r[1]=u*C+f*N+h*F+d*oe,r[5]=u*v+f*L+h*H+d*Z,r[9]=u*A+f*k+h*Y+d*Q,r[13]=u*B+f*V+h*G+d*se,r[2]=p*C+y*N+_*F+g*oe,r[6]=p*v+y*L+_*H+g*Z,r[10]=p*A+y*k+_*Y+g*Q,r[14]=p*B+y*V+_*G+g*se,r[3]=b*C+E*N+S*F+P*oe,r[7]=b*v+E*L+S*H+P*Z,r[11]=b*A+E*k+S*Y+P*Q,r[15]=b*B+E*V+S*G+P*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],y=e[7],_=e[11],g=e[15],b=l*d-c*h,E=a*d-c*f,S=a*h-l*f,P=o*d-c*u,C=o*h-l*u,v=o*f-a*u;return t*(y*b-_*E+g*S)-i*(p*b-_*P+g*C)+s*(p*E-y*P+g*v)-r*(p*S-y*C+_*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],y=e[13],_=e[14],g=e[15],b=t*a-i*o,E=t*l-s*o,S=t*c-r*o,P=i*l-s*a,C=i*c-r*a,v=s*c-r*l,A=u*y-f*p,B=u*_-h*p,N=u*g-d*p,L=f*_-h*y,k=f*g-d*y,V=h*g-d*_,F=b*V-E*k+S*L+P*N-C*B+v*A;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/F;return e[0]=(a*V-l*k+c*L)*H,e[1]=(s*k-i*V-r*L)*H,e[2]=(y*v-_*C+g*P)*H,e[3]=(h*C-f*v-d*P)*H,e[4]=(l*N-o*V-c*B)*H,e[5]=(t*V-s*N+r*B)*H,e[6]=(_*S-p*v-g*E)*H,e[7]=(u*v-h*S+d*E)*H,e[8]=(o*k-a*N+c*A)*H,e[9]=(i*N-t*k-r*A)*H,e[10]=(p*C-y*S+g*b)*H,e[11]=(f*S-u*C-d*b)*H,e[12]=(a*B-o*L-l*A)*H,e[13]=(t*L-i*B+s*A)*H,e[14]=(y*E-p*P-_*b)*H,e[15]=(u*P-f*E+h*b)*H,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,y=o*u,_=o*f,g=a*f,b=l*c,E=l*u,S=l*f,P=i.x,C=i.y,v=i.z;return s[0]=(1-(y+g))*P,s[1]=(d+S)*P,s[2]=(p-E)*P,s[3]=0,s[4]=(d-S)*C,s[5]=(1-(h+g))*C,s[6]=(_+b)*C,s[7]=0,s[8]=(p+E)*v,s[9]=(_-b)*v,s[10]=(1-(h+y))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Io.set(s[0],s[1],s[2]).length(),a=Io.set(s[4],s[5],s[6]).length(),l=Io.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Xi.copy(this);let c=1/o,u=1/a,f=1/l;return Xi.elements[0]*=c,Xi.elements[1]*=c,Xi.elements[2]*=c,Xi.elements[4]*=u,Xi.elements[5]*=u,Xi.elements[6]*=u,Xi.elements[8]*=f,Xi.elements[9]*=f,Xi.elements[10]*=f,t.setFromRotationMatrix(Xi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Fi,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===Fi)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===$a)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Fi,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===Fi)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===$a)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Io=new K,Xi=new en,xM=new K(0,0,0),bM=new K(1,1,1),rr=new K,gc=new K,gi=new K,C_=new en,R_=new xi,hr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return C_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(C_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return R_.setFromEuler(this),this.setFromQuaternion(R_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};hr.DEFAULT_ORDER="XYZ";var Ja=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},SM=0,P_=new K,Lo=new xi,Cs=new en,_c=new K,Oa=new K,MM=new K,wM=new xi,I_=new K(1,0,0),L_=new K(0,1,0),D_=new K(0,0,1),N_={type:"added"},TM={type:"removed"},Do={type:"childadded",child:null},Kf={type:"childremoved",child:null},Si=class n extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:SM++}),this.uuid=sa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new K,t=new hr,i=new xi,s=new K(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new en},normalMatrix:{value:new et}}),this.matrix=new en,this.matrixWorld=new en,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ja,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Lo.setFromAxisAngle(e,t),this.quaternion.multiply(Lo),this}rotateOnWorldAxis(e,t){return Lo.setFromAxisAngle(e,t),this.quaternion.premultiply(Lo),this}rotateX(e){return this.rotateOnAxis(I_,e)}rotateY(e){return this.rotateOnAxis(L_,e)}rotateZ(e){return this.rotateOnAxis(D_,e)}translateOnAxis(e,t){return P_.copy(e).applyQuaternion(this.quaternion),this.position.add(P_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(I_,e)}translateY(e){return this.translateOnAxis(L_,e)}translateZ(e){return this.translateOnAxis(D_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Cs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?_c.copy(e):_c.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Oa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Cs.lookAt(Oa,_c,this.up):Cs.lookAt(_c,Oa,this.up),this.quaternion.setFromRotationMatrix(Cs),s&&(Cs.extractRotation(s.matrixWorld),Lo.setFromRotationMatrix(Cs),this.quaternion.premultiply(Lo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(N_),Do.child=e,this.dispatchEvent(Do),Do.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(TM),Kf.child=e,this.dispatchEvent(Kf),Kf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Cs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Cs.multiply(e.parent.matrixWorld)),e.applyMatrix4(Cs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(N_),Do.child=e,this.dispatchEvent(Do),Do.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Oa,e,MM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Oa,wM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Si.DEFAULT_UP=new K(0,1,0);Si.DEFAULT_MATRIX_AUTO_UPDATE=!0;Si.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Gr=class extends Si{constructor(){super(),this.isGroup=!0,this.type="Group"}},EM={type:"move"},$o=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Gr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Gr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Gr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let _=t.getJointPose(y,i),g=this._getHandJoint(c,y);_!==null&&(g.matrix.fromArray(_.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=_.radius),g.visible=_!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(EM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Gr;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},N0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},or={h:0,s:0,l:0},vc={h:0,s:0,l:0};function Jf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var xt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=vi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=i,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=yt.workingColorSpace){if(e=Xd(e,1),t=mt(t,0,1),i=mt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Jf(o,r,e+1/3),this.g=Jf(o,r,e),this.b=Jf(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=vi){function i(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=vi){let i=N0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ds(e.r),this.g=Ds(e.g),this.b=Ds(e.b),this}copyLinearToSRGB(e){return this.r=Ho(e.r),this.g=Ho(e.g),this.b=Ho(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=vi){return yt.workingToColorSpace(Wn.copy(this),e),Math.round(mt(Wn.r*255,0,255))*65536+Math.round(mt(Wn.g*255,0,255))*256+Math.round(mt(Wn.b*255,0,255))}getHexString(e=vi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace(Wn.copy(this),t);let i=Wn.r,s=Wn.g,r=Wn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace(Wn.copy(this),t),e.r=Wn.r,e.g=Wn.g,e.b=Wn.b,e}getStyle(e=vi){yt.workingToColorSpace(Wn.copy(this),e);let t=Wn.r,i=Wn.g,s=Wn.b;return e!==vi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(or),this.setHSL(or.h+e,or.s+t,or.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(or),e.getHSL(vc);let i=Wa(or.h,vc.h,t),s=Wa(or.s,vc.s,t),r=Wa(or.l,vc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wn=new xt;xt.NAMES=N0;var ja=class extends Si{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new hr,this.environmentIntensity=1,this.environmentRotation=new hr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Yi=new K,Rs=new K,jf=new K,Ps=new K,No=new K,Fo=new K,F_=new K,Qf=new K,ed=new K,td=new K,nd=new tn,id=new tn,sd=new tn,ur=class n{constructor(e=new K,t=new K,i=new K){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Yi.subVectors(e,t),s.cross(Yi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Yi.subVectors(s,t),Rs.subVectors(i,t),jf.subVectors(e,t);let o=Yi.dot(Yi),a=Yi.dot(Rs),l=Yi.dot(jf),c=Rs.dot(Rs),u=Rs.dot(jf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ps)===null?!1:Ps.x>=0&&Ps.y>=0&&Ps.x+Ps.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ps)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ps.x),l.addScaledVector(o,Ps.y),l.addScaledVector(a,Ps.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return nd.setScalar(0),id.setScalar(0),sd.setScalar(0),nd.fromBufferAttribute(e,t),id.fromBufferAttribute(e,i),sd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(nd,r.x),o.addScaledVector(id,r.y),o.addScaledVector(sd,r.z),o}static isFrontFacing(e,t,i,s){return Yi.subVectors(i,t),Rs.subVectors(e,t),Yi.cross(Rs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Yi.subVectors(this.c,this.b),Rs.subVectors(this.a,this.b),Yi.cross(Rs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;No.subVectors(s,i),Fo.subVectors(r,i),Qf.subVectors(e,i);let l=No.dot(Qf),c=Fo.dot(Qf);if(l<=0&&c<=0)return t.copy(i);ed.subVectors(e,s);let u=No.dot(ed),f=Fo.dot(ed);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(No,o);td.subVectors(e,r);let d=No.dot(td),p=Fo.dot(td);if(p>=0&&d<=p)return t.copy(r);let y=d*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Fo,a);let _=u*p-d*f;if(_<=0&&f-u>=0&&d-p>=0)return F_.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(F_,a);let g=1/(_+y+h);return o=y*g,a=h*g,t.copy(i).addScaledVector(No,o).addScaledVector(Fo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ps=class{constructor(e=new K(1/0,1/0,1/0),t=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint($i.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint($i.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=$i.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,$i):$i.fromBufferAttribute(r,o),$i.applyMatrix4(e.matrixWorld),this.expandByPoint($i);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),yc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),yc.copy(i.boundingBox)),yc.applyMatrix4(e.matrixWorld),this.union(yc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$i),$i.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ba),xc.subVectors(this.max,Ba),Uo.subVectors(e.a,Ba),Oo.subVectors(e.b,Ba),Bo.subVectors(e.c,Ba),ar.subVectors(Oo,Uo),lr.subVectors(Bo,Oo),Or.subVectors(Uo,Bo);let t=[0,-ar.z,ar.y,0,-lr.z,lr.y,0,-Or.z,Or.y,ar.z,0,-ar.x,lr.z,0,-lr.x,Or.z,0,-Or.x,-ar.y,ar.x,0,-lr.y,lr.x,0,-Or.y,Or.x,0];return!rd(t,Uo,Oo,Bo,xc)||(t=[1,0,0,0,1,0,0,0,1],!rd(t,Uo,Oo,Bo,xc))?!1:(bc.crossVectors(ar,lr),t=[bc.x,bc.y,bc.z],rd(t,Uo,Oo,Bo,xc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$i).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($i).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Is[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Is[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Is[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Is[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Is[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Is[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Is[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Is[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Is),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Is=[new K,new K,new K,new K,new K,new K,new K,new K],$i=new K,yc=new ps,Uo=new K,Oo=new K,Bo=new K,ar=new K,lr=new K,Or=new K,Ba=new K,xc=new K,bc=new K,Br=new K;function rd(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Br.fromArray(n,r);let a=s.x*Math.abs(Br.x)+s.y*Math.abs(Br.y)+s.z*Math.abs(Br.z),l=e.dot(Br),c=t.dot(Br),u=i.dot(Br);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Sn=new K,Sc=new it,AM=0,ei=class extends Zi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:AM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=A0,this.updateRanges=[],this.gpuType=Ji,this.version=0,this._normalizationScale=e!==void 0?$d(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Sc.fromBufferAttribute(this,t),Sc.applyMatrix3(e),this.setXY(t,Sc.x,Sc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.applyMatrix3(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.applyMatrix4(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.applyNormalMatrix(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.transformDirection(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):L0(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):D0(e,this.array)}};var Qa=class extends ei{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var el=class extends ei{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var ri=class extends ei{constructor(e,t,i){super(new Float32Array(e),t,i)}},CM=new ps,ka=new K,od=new K,Fs=class{constructor(e=new K,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):CM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ka.subVectors(e,this.center);let t=ka.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ka,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(od.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ka.copy(e.center).add(od)),this.expandByPoint(ka.copy(e.center).sub(od))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},RM=0,Ni=new en,ad=new Si,ko=new K,_i=new ps,za=new ps,Un=new K,ms=class n extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:RM++}),this.uuid=sa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(eM(e)?el:Qa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ni.makeRotationFromQuaternion(e),this.applyMatrix4(Ni),this}rotateX(e){return Ni.makeRotationX(e),this.applyMatrix4(Ni),this}rotateY(e){return Ni.makeRotationY(e),this.applyMatrix4(Ni),this}rotateZ(e){return Ni.makeRotationZ(e),this.applyMatrix4(Ni),this}translate(e,t,i){return Ni.makeTranslation(e,t,i),this.applyMatrix4(Ni),this}scale(e,t,i){return Ni.makeScale(e,t,i),this.applyMatrix4(Ni),this}lookAt(e){return ad.lookAt(e),ad.updateMatrix(),this.applyMatrix4(ad.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ko).negate(),this.translate(ko.x,ko.y,ko.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ri(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ps);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Fs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(e){let i=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];za.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(_i.min,za.min),_i.expandByPoint(Un),Un.addVectors(_i.max,za.max),_i.expandByPoint(Un)):(_i.expandByPoint(za.min),_i.expandByPoint(za.max))}_i.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Un.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Un));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Un.fromBufferAttribute(a,c),l&&(ko.fromBufferAttribute(e,c),Un.add(ko)),s=Math.max(s,i.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ei(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new K,l[B]=new K;let u=new K,f=new K,h=new K,d=new it,p=new it,y=new it,_=new K,g=new K;function b(B,N,L){c[B]=c[N]=c[L]=1,u.fromBufferAttribute(i,B),f.fromBufferAttribute(i,N),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,B),p.fromBufferAttribute(r,N),y.fromBufferAttribute(r,L),f.sub(u),h.sub(u),p.sub(d),y.sub(d);let k=1/(p.x*y.y-y.x*p.y);isFinite(k)&&(_.copy(f).multiplyScalar(y.y).addScaledVector(h,-p.y).multiplyScalar(k),g.copy(h).multiplyScalar(p.x).addScaledVector(f,-y.x).multiplyScalar(k),a[B].add(_),a[N].add(_),a[L].add(_),l[B].add(g),l[N].add(g),l[L].add(g))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let B=0,N=E.length;B<N;++B){let L=E[B],k=L.start,V=L.count;for(let F=k,H=k+V;F<H;F+=3)b(e.getX(F+0),e.getX(F+1),e.getX(F+2))}let S=new K,P=new K,C=new K,v=new K;function A(B){C.fromBufferAttribute(s,B),v.copy(C);let N=a[B];S.copy(N),S.sub(C.multiplyScalar(C.dot(N))).normalize(),P.crossVectors(v,N);let k=P.dot(l[B])<0?-1:1;o.setXYZW(B,S.x,S.y,S.z,k)}for(let B=0,N=i.count;B<N;++B)c[B]&&A(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ei(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new K,r=new K,o=new K,a=new K,l=new K,c=new K,u=new K,f=new K;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),y=e.getX(h+1),_=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,_),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,_),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(_,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Un.fromBufferAttribute(e,t),Un.normalize(),e.setXYZ(t,Un.x,Un.y,Un.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let y=0,_=l.length;y<_;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let g=0;g<u;g++)h[p++]=c[d++]}return new ei(h,u,f)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var ld=new K,PM=new K,IM=new et,yi=class{constructor(e=new K(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=ld.subVectors(i,t).cross(PM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(ld),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||IM.getNormalMatrix(e),s=this.coplanarPoint(ld).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},LM=0,fr=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:LM++}),this.uuid=sa(),this.name="",this.type="Material",this.blending=ta,this.side=vr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Sd,this.blendDst=Md,this.blendEquation=Xr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new xt(0,0,0),this.blendAlpha=0,this.depthFunc=Wo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=b0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=kc,this.stencilZFail=kc,this.stencilZPass=kc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new xt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new yi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new it().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ls=new K,cd=new K,Mc=new K,wc=new K,Vr=class{constructor(e=new K,t=new K(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ls)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ls.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ls.copy(this.origin).addScaledVector(this.direction,t),Ls.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){cd.copy(e).add(t).multiplyScalar(.5),Mc.copy(t).sub(e).normalize(),wc.copy(this.origin).sub(cd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Mc),a=wc.dot(this.direction),l=-wc.dot(Mc),c=wc.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let y=1/u;f*=y,h*=y,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(cd).addScaledVector(Mc,h),d}intersectSphere(e,t){if(e.radius<0)return null;Ls.subVectors(e.center,this.origin);let i=Ls.dot(this.direction),s=Ls.dot(Ls)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Ls)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,y=t.y-o.y,_=t.z-o.z,g=i.x-o.x,b=i.y-o.y,E=i.z-o.z,S=Math.abs(l),P=Math.abs(c),C=Math.abs(u),v,A,B,N,L,k,V,F,H,Y,G,oe;if(S>=P&&S>=C?(B=l,k=f,H=p,oe=g,l>=0?(v=c,A=u,N=h,L=d,V=y,F=_,Y=b,G=E):(v=u,A=c,N=d,L=h,V=_,F=y,Y=E,G=b)):P>=C?(B=c,k=h,H=y,oe=b,c>=0?(v=u,A=l,N=d,L=f,V=_,F=p,Y=E,G=g):(v=l,A=u,N=f,L=d,V=p,F=_,Y=g,G=E)):(B=u,k=d,H=_,oe=E,u>=0?(v=l,A=c,N=f,L=h,V=p,F=y,Y=g,G=b):(v=c,A=l,N=h,L=f,V=y,F=p,Y=b,G=g)),B===0)return null;let Z=v/B,Q=A/B,se=1/B,fe=N-Z*k,he=L-Q*k,ee=V-Z*H,me=F-Q*H,ve=Y-Z*oe,Ae=G-Q*oe,Se=ve*me-Ae*ee,We=fe*Ae-he*ve,ot=ee*he-me*fe;if(s){if(Se<0||We<0||ot<0)return null}else if((Se<0||We<0||ot<0)&&(Se>0||We>0||ot>0))return null;let Ve=Se+We+ot;if(Ve===0)return null;let ft=se*(Se*k+We*H+ot*oe);return(Ve>0?ft<0:ft>0)?null:this.at(ft/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Qc=class extends fr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hr,this.combine=wd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},U_=new en,kr=new Vr,Tc=new Fs,O_=new K,Ec=new K,Ac=new K,Cc=new K,ud=new K,Rc=new K,B_=new K,Pc=new K,Ui=class extends Si{constructor(e=new ms,t=new Qc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Rc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(ud.fromBufferAttribute(f,e),o?Rc.addScaledVector(ud,u):Rc.addScaledVector(ud.sub(t),u))}t.add(Rc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Tc.copy(i.boundingSphere),Tc.applyMatrix4(r),kr.copy(e.ray).recast(e.near),!(Tc.containsPoint(kr.origin)===!1&&(kr.intersectSphere(Tc,O_)===null||kr.origin.distanceToSquared(O_)>(e.far-e.near)**2))&&(U_.copy(r).invert(),kr.copy(e.ray).applyMatrix4(U_),!(i.boundingBox!==null&&kr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,kr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=h.length;p<y;p++){let _=h[p],g=o[_.materialIndex],b=Math.max(_.start,d.start),E=Math.min(a.count,Math.min(_.start+_.count,d.start+d.count));for(let S=b,P=E;S<P;S+=3){let C=a.getX(S),v=a.getX(S+1),A=a.getX(S+2);s=Ic(this,g,e,i,c,u,f,C,v,A),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let _=p,g=y;_<g;_+=3){let b=a.getX(_),E=a.getX(_+1),S=a.getX(_+2);s=Ic(this,o,e,i,c,u,f,b,E,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=h.length;p<y;p++){let _=h[p],g=o[_.materialIndex],b=Math.max(_.start,d.start),E=Math.min(l.count,Math.min(_.start+_.count,d.start+d.count));for(let S=b,P=E;S<P;S+=3){let C=S,v=S+1,A=S+2;s=Ic(this,g,e,i,c,u,f,C,v,A),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let _=p,g=y;_<g;_+=3){let b=_,E=_+1,S=_+2;s=Ic(this,o,e,i,c,u,f,b,E,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}}};function DM(n,e,t,i,s,r,o,a){let l;if(e.side===ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===vr,a),l===null)return null;Pc.copy(a),Pc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Pc);return c<t.near||c>t.far?null:{distance:c,point:Pc.clone(),object:n}}function Ic(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Ec),n.getVertexPosition(l,Ac),n.getVertexPosition(c,Cc);let u=DM(n,e,t,i,Ec,Ac,Cc,B_);if(u){let f=new K;ur.getBarycoord(B_,Ec,Ac,Cc,f),s&&(u.uv=ur.getInterpolatedAttribute(s,a,l,c,f,new it)),r&&(u.uv1=ur.getInterpolatedAttribute(r,a,l,c,f,new it)),o&&(u.normal=ur.getInterpolatedAttribute(o,a,l,c,f,new K),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new K,materialIndex:0};ur.getNormal(Ec,Ac,Cc,h.normal),u.face=h,u.barycoord=f}return u}var Hr=class extends oi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=On,u=On,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zo=class extends ei{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var zr=new Fs,NM=new it(.5,.5),Lc=new K,Wr=class{constructor(e=new yi,t=new yi,i=new yi,s=new yi,r=new yi,o=new yi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Fi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],y=r[9],_=r[10],g=r[11],b=r[12],E=r[13],S=r[14],P=r[15];if(s[0].setComponents(c-o,d-u,g-p,P-b).normalize(),s[1].setComponents(c+o,d+u,g+p,P+b).normalize(),s[2].setComponents(c+a,d+f,g+y,P+E).normalize(),s[3].setComponents(c-a,d-f,g-y,P-E).normalize(),i)s[4].setComponents(l,h,_,S).normalize(),s[5].setComponents(c-l,d-h,g-_,P-S).normalize();else if(s[4].setComponents(c-l,d-h,g-_,P-S).normalize(),t===Fi)s[5].setComponents(c+l,d+h,g+_,P+S).normalize();else if(t===$a)s[5].setComponents(l,h,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),zr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),zr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(zr)}intersectsSprite(e){zr.center.set(0,0,0);let t=NM.distanceTo(e.center);return zr.radius=.7071067811865476+t,zr.applyMatrix4(e.matrixWorld),this.intersectsSphere(zr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Lc.x=s.normal.x>0?e.max.x:e.min.x,Lc.y=s.normal.y>0?e.max.y:e.min.y,Lc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Lc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},k_=new en,eu=class n{constructor(){this.coordinateSystem=Fi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];k_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Wr),i[s].setFromProjectionMatrix(k_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Wr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var tu=class extends fr{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new xt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},nu=new K,iu=new K,z_=new en,Ga=new Vr,Dc=new Fs,hd=new K,G_=new K,su=class extends Si{constructor(e=new ms,t=new tu){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)nu.fromBufferAttribute(t,s-1),iu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=nu.distanceTo(iu);e.setAttribute("lineDistance",new ri(i,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Dc.copy(i.boundingSphere),Dc.applyMatrix4(s),Dc.radius+=r,e.ray.intersectsSphere(Dc)===!1)return;z_.copy(s).invert(),Ga.copy(e.ray).applyMatrix4(z_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=d,_=p-1;y<_;y+=c){let g=u.getX(y),b=u.getX(y+1),E=Nc(this,e,Ga,l,g,b,y);E&&t.push(E)}if(this.isLineLoop){let y=u.getX(p-1),_=u.getX(d),g=Nc(this,e,Ga,l,y,_,p-1);g&&t.push(g)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let y=d,_=p-1;y<_;y+=c){let g=Nc(this,e,Ga,l,y,y+1,y);g&&t.push(g)}if(this.isLineLoop){let y=Nc(this,e,Ga,l,p-1,d,p-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Nc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(nu.fromBufferAttribute(a,s),iu.fromBufferAttribute(a,r),t.distanceSqToSegment(nu,iu,hd,G_)>i)return;hd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(hd);if(!(c<e.near||c>e.far))return{distance:c,point:G_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var V_=new K,H_=new K,tl=class extends su{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)V_.fromBufferAttribute(t,s),H_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+V_.distanceTo(H_);e.setAttribute("lineDistance",new ri(i,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var nl=class extends oi{constructor(e=[],t=Yr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Us=class extends oi{constructor(e,t,i=Ki,s,r,o,a=On,l=On,c,u=Ns,f=1){if(u!==Ns&&u!==Bs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Yo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},il=class extends Us{constructor(e,t=Ki,i=Yr,s,r,o=On,a=On,l,c=Ns){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},sl=class extends oi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Ko=class n extends ms{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ri(c,3)),this.setAttribute("normal",new ri(u,3)),this.setAttribute("uv",new ri(f,2));function p(y,_,g,b,E,S,P,C,v,A,B){let N=S/v,L=P/A,k=S/2,V=P/2,F=C/2,H=v+1,Y=A+1,G=0,oe=0,Z=new K;for(let Q=0;Q<Y;Q++){let se=Q*L-V;for(let fe=0;fe<H;fe++){let he=fe*N-k;Z[y]=he*b,Z[_]=se*E,Z[g]=F,c.push(Z.x,Z.y,Z.z),Z[y]=0,Z[_]=0,Z[g]=C>0?1:-1,u.push(Z.x,Z.y,Z.z),f.push(fe/v),f.push(1-Q/A),G+=1}}for(let Q=0;Q<A;Q++)for(let se=0;se<v;se++){let fe=h+se+H*Q,he=h+se+H*(Q+1),ee=h+(se+1)+H*(Q+1),me=h+(se+1)+H*Q;l.push(fe,he,me),l.push(he,ee,me),oe+=6}a.addGroup(d,oe,B),d+=oe,h+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var rl=class n extends ms{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],y=[],_=[];for(let g=0;g<u;g++){let b=g*h-o;for(let E=0;E<c;E++){let S=E*f-r;p.push(S,-b,0),y.push(0,0,1),_.push(E/a),_.push(1-g/l)}}for(let g=0;g<l;g++)for(let b=0;b<a;b++){let E=b+c*g,S=b+c*(g+1),P=b+1+c*(g+1),C=b+1+c*g;d.push(E,S,C),d.push(S,P,C)}this.setIndex(d),this.setAttribute("position",new ri(p,3)),this.setAttribute("normal",new ri(y,3)),this.setAttribute("uv",new ri(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function Zr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(W_(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(W_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function qn(n){let e={};for(let t=0;t<n.length;t++){let i=Zr(n[t]);for(let s in i)e[s]=i[s]}return e}function W_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function FM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Kd(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var F0={clone:Zr,merge:qn},UM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,OM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Mi=class extends fr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=UM,this.fragmentShader=OM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Zr(e.uniforms),this.uniformsGroups=FM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new xt().setHex(s.value);break;case"v2":this.uniforms[i].value=new it().fromArray(s.value);break;case"v3":this.uniforms[i].value=new K().fromArray(s.value);break;case"v4":this.uniforms[i].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new en().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ru=class extends Mi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ou=class extends fr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=y0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},au=class extends fr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function zo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Fc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var dr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},lu=class extends dr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:dd,endingEnd:dd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case pd:r=e,a=2*t-i;break;case md:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case pd:o=e,l=2*i-t;break;case md:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),y=p*p,_=y*p,g=-h*_+2*h*y-h*p,b=(1+h)*_+(-1.5-2*h)*y+(-.5+h)*p+1,E=(-1-d)*_+(1.5+d)*y+.5*p,S=d*_-d*y;for(let P=0;P!==a;++P)r[P]=g*o[u+P]+b*o[c+P]+E*o[l+P]+S*o[f+P];return r}},cu=class extends dr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},uu=class extends dr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},hu=class extends dr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),y=1-p;for(let _=0;_!==a;++_)r[_]=o[c+_]*y+o[l+_]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let y=o[c+p],_=o[l+p],g=d*h+p*2,b=f[g],E=f[g+1],S=e*h+p*2,P=u[S],C=u[S+1],v=kM(i,t,b,P,s);r[p]=U0(v,y,E,C,_)}return r}};function U0(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function BM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function kM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=U0(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=BM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var wi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=zo(t,this.TimeBufferType),this.values=zo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:zo(e.times,Array),values:zo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Fc(e.settings)&&(i.settings={inTangents:zo(e.settings.inTangents,Array),outTangents:zo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new uu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new cu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new lu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new hu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case qa:t=this.InterpolantFactoryMethodDiscrete;break;case Zc:t=this.InterpolantFactoryMethodLinear;break;case Bc:t=this.InterpolantFactoryMethodSmooth;break;case fd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $e("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return qa;case this.InterpolantFactoryMethodLinear:return Zc;case this.InterpolantFactoryMethodSmooth:return Bc;case this.InterpolantFactoryMethodBezier:return fd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Fc(this.settings)&&(q_(this.settings.inTangents,e),q_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Fc(this.settings)&&(X_(this.settings.inTangents,e),X_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&tM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Bc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let y=t[f+p];if(y!==t[h+p]||y!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Fc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function q_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function X_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}wi.prototype.ValueTypeName="";wi.prototype.TimeBufferType=Float32Array;wi.prototype.ValueBufferType=Float32Array;wi.prototype.DefaultInterpolation=Zc;var pr=class extends wi{constructor(e,t,i){super(e,t,i)}};pr.prototype.ValueTypeName="bool";pr.prototype.ValueBufferType=Array;pr.prototype.DefaultInterpolation=qa;pr.prototype.InterpolantFactoryMethodLinear=void 0;pr.prototype.InterpolantFactoryMethodSmooth=void 0;var fu=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};fu.prototype.ValueTypeName="color";var du=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};du.prototype.ValueTypeName="number";var pu=class extends dr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)xi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ol=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new pu(this.times,this.values,this.getValueSize(),e)}};ol.prototype.ValueTypeName="quaternion";ol.prototype.InterpolantFactoryMethodSmooth=void 0;var mr=class extends wi{constructor(e,t,i){super(e,t,i)}};mr.prototype.ValueTypeName="string";mr.prototype.ValueBufferType=Array;mr.prototype.DefaultInterpolation=qa;mr.prototype.InterpolantFactoryMethodLinear=void 0;mr.prototype.InterpolantFactoryMethodSmooth=void 0;var mu=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};mu.prototype.ValueTypeName="vector";var gu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},O0=new gu,_u=class{constructor(e){this.manager=e!==void 0?e:O0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};_u.DEFAULT_MATERIAL_NAME="__DEFAULT";var Uc=new K,Oc=new xi,fs=new K,al=class extends Si{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new en,this.projectionMatrix=new en,this.projectionMatrixInverse=new en,this.coordinateSystem=Fi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Uc,Oc,fs),fs.x===1&&fs.y===1&&fs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Oc,fs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Uc,Oc,fs),fs.x===1&&fs.y===1&&fs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Uc,Oc,fs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},cr=new K,Y_=new it,$_=new it,Qn=class extends al{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Xo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ha*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Xo*2*Math.atan(Math.tan(Ha*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){cr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(cr.x,cr.y).multiplyScalar(-e/cr.z),cr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(cr.x,cr.y).multiplyScalar(-e/cr.z)}getViewSize(e,t){return this.getViewBounds(e,Y_,$_),t.subVectors($_,Y_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ha*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var vu=class extends al{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Jo=class extends ms{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Go=-90,Vo=1,jo=class extends Si{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Qn(Go,Vo,e,t);s.layers=this.layers,this.add(s);let r=new Qn(Go,Vo,e,t);r.layers=this.layers,this.add(r);let o=new Qn(Go,Vo,e,t);o.layers=this.layers,this.add(o);let a=new Qn(Go,Vo,e,t);a.layers=this.layers,this.add(a);let l=new Qn(Go,Vo,e,t);l.layers=this.layers,this.add(l);let c=new Qn(Go,Vo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Fi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===$a)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},yu=class extends Qn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Jd="\\[\\]\\.:\\/",zM=new RegExp("["+Jd+"]","g"),jd="[^"+Jd+"]",GM="[^"+Jd.replace("\\.","")+"]",VM=/((?:WC+[\/:])*)/.source.replace("WC",jd),HM=/(WCOD+)?/.source.replace("WCOD",GM),WM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",jd),qM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",jd),XM=new RegExp("^"+VM+HM+WM+qM+"$"),YM=["material","materials","bones","map"],gd=class{constructor(e,t,i){let s=i||$t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},$t=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(zM,"")}static parseTrackName(e){let t=XM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);YM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$t.Composite=gd;$t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$t.prototype.GetterByBindingType=[$t.prototype._getValue_direct,$t.prototype._getValue_array,$t.prototype._getValue_arrayElement,$t.prototype._getValue_toArray];$t.prototype.SetterByBindingTypeAndVersioning=[[$t.prototype._setValue_direct,$t.prototype._setValue_direct_setNeedsUpdate,$t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_array,$t.prototype._setValue_array_setNeedsUpdate,$t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_arrayElement,$t.prototype._setValue_arrayElement_setNeedsUpdate,$t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_fromArray,$t.prototype._setValue_fromArray_setNeedsUpdate,$t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var XI=new Float32Array(1);var Qo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var _d=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var ll=class extends Zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Qd(n,e,t,i){let s=$M(i);switch(t){case Od:return n*e;case kd:return n*e/s.components*s.byteLength;case Eu:return n*e/s.components*s.byteLength;case yr:return n*e*2/s.components*s.byteLength;case Au:return n*e*2/s.components*s.byteLength;case Bd:return n*e*3/s.components*s.byteLength;case Qi:return n*e*4/s.components*s.byteLength;case Cu:return n*e*4/s.components*s.byteLength;case hl:case fl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case dl:case pl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Pu:case Lu:return Math.max(n,16)*Math.max(e,8)/4;case Ru:case Iu:return Math.max(n,8)*Math.max(e,8)/2;case Du:case Nu:case Uu:case Ou:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Fu:case ml:case Bu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ku:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case zu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Gu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Vu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Hu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Wu:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case qu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Xu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Yu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case $u:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Zu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Ku:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Ju:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case ju:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Qu:case eh:case th:return Math.ceil(n/4)*Math.ceil(e/4)*16;case nh:case ih:return Math.ceil(n/4)*Math.ceil(e/4)*8;case gl:case sh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function $M(n){switch(n){case Ti:case Dd:return{byteLength:1,components:1};case ia:case Nd:case ji:return{byteLength:2,components:1};case wu:case Tu:return{byteLength:2,components:4};case Ki:case Mu:case Ji:return{byteLength:4,components:1};case Fd:case Ud:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function rv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function KM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],y=f[d];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++h,f[h]=y)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let y=f[d];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var JM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,jM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,QM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ew=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,tw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,nw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,iw=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,sw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,rw=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,ow=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,aw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,lw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,cw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,uw=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,hw=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,fw=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,dw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,pw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,mw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,gw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,_w=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,vw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,yw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,xw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,bw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Sw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Mw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ww=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Tw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ew="gl_FragColor = linearToOutputTexel( gl_FragColor );",Aw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Cw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Rw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Pw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Iw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Lw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Dw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Nw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Fw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Uw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ow=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Bw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,kw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,zw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Gw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Vw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Hw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ww=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,qw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Xw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Yw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,$w=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Zw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Kw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Jw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,jw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Qw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,e1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,t1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,n1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,i1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,s1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,r1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,o1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,a1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,l1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,c1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,u1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,h1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,f1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,d1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,p1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,m1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,g1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,v1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,y1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,x1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,b1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,S1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,M1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,w1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,T1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,E1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,A1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,C1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,R1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,P1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,I1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,L1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,D1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,N1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,F1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,U1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,O1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,B1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,k1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,z1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,G1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,V1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,H1=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,W1=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,q1=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,X1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Y1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,$1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Z1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,K1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,J1=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,j1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Q1=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,iT=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,sT=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,rT=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,oT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,aT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lT=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,cT=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,uT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,hT=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fT=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,dT=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pT=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,mT=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gT=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,_T=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,vT=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,bT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ST=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,MT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,TT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ET=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,AT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,CT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,RT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:JM,alphahash_pars_fragment:jM,alphamap_fragment:QM,alphamap_pars_fragment:ew,alphatest_fragment:tw,alphatest_pars_fragment:nw,aomap_fragment:iw,aomap_pars_fragment:sw,batching_pars_vertex:rw,batching_vertex:ow,begin_vertex:aw,beginnormal_vertex:lw,bsdfs:cw,iridescence_fragment:uw,bumpmap_pars_fragment:hw,clipping_planes_fragment:fw,clipping_planes_pars_fragment:dw,clipping_planes_pars_vertex:pw,clipping_planes_vertex:mw,color_fragment:gw,color_pars_fragment:_w,color_pars_vertex:vw,color_vertex:yw,common:xw,defaultnormal_vertex:bw,displacementmap_pars_vertex:Sw,displacementmap_vertex:Mw,emissivemap_fragment:ww,emissivemap_pars_fragment:Tw,colorspace_fragment:Ew,colorspace_pars_fragment:Aw,envmap_fragment:Cw,envmap_common_pars_fragment:Rw,envmap_pars_fragment:Pw,envmap_pars_vertex:Iw,envmap_physical_pars_fragment:Vw,envmap_vertex:Lw,fog_vertex:Dw,fog_pars_vertex:Nw,fog_fragment:Fw,fog_pars_fragment:Uw,gradientmap_pars_fragment:Ow,lightmap_pars_fragment:Bw,lights_lambert_fragment:kw,lights_lambert_pars_fragment:zw,lights_pars_begin:Gw,lights_toon_fragment:Hw,lights_toon_pars_fragment:Ww,lights_phong_fragment:qw,lights_phong_pars_fragment:Xw,lights_physical_fragment:Yw,lights_physical_pars_fragment:$w,lights_fragment_begin:Zw,lights_fragment_maps:Kw,lights_fragment_end:Jw,lightprobes_pars_fragment:jw,logdepthbuf_fragment:Qw,logdepthbuf_pars_fragment:e1,logdepthbuf_pars_vertex:t1,logdepthbuf_vertex:n1,map_fragment:i1,map_pars_fragment:s1,map_particle_fragment:r1,map_particle_pars_fragment:o1,metalnessmap_fragment:a1,metalnessmap_pars_fragment:l1,morphinstance_vertex:c1,morphcolor_vertex:u1,morphnormal_vertex:h1,morphtarget_pars_vertex:f1,morphtarget_vertex:d1,normal_fragment_begin:p1,normal_fragment_maps:m1,normal_pars_fragment:g1,normal_pars_vertex:_1,normal_vertex:v1,normalmap_pars_fragment:y1,clearcoat_normal_fragment_begin:x1,clearcoat_normal_fragment_maps:b1,clearcoat_pars_fragment:S1,iridescence_pars_fragment:M1,opaque_fragment:w1,packing:T1,premultiplied_alpha_fragment:E1,project_vertex:A1,dithering_fragment:C1,dithering_pars_fragment:R1,roughnessmap_fragment:P1,roughnessmap_pars_fragment:I1,shadowmap_pars_fragment:L1,shadowmap_pars_vertex:D1,shadowmap_vertex:N1,shadowmask_pars_fragment:F1,skinbase_vertex:U1,skinning_pars_vertex:O1,skinning_vertex:B1,skinnormal_vertex:k1,specularmap_fragment:z1,specularmap_pars_fragment:G1,tonemapping_fragment:V1,tonemapping_pars_fragment:H1,transmission_fragment:W1,transmission_pars_fragment:q1,uv_pars_fragment:X1,uv_pars_vertex:Y1,uv_vertex:$1,worldpos_vertex:Z1,background_vert:K1,background_frag:J1,backgroundCube_vert:j1,backgroundCube_frag:Q1,cube_vert:eT,cube_frag:tT,depth_vert:nT,depth_frag:iT,distance_vert:sT,distance_frag:rT,equirect_vert:oT,equirect_frag:aT,linedashed_vert:lT,linedashed_frag:cT,meshbasic_vert:uT,meshbasic_frag:hT,meshlambert_vert:fT,meshlambert_frag:dT,meshmatcap_vert:pT,meshmatcap_frag:mT,meshnormal_vert:gT,meshnormal_frag:_T,meshphong_vert:vT,meshphong_frag:yT,meshphysical_vert:xT,meshphysical_frag:bT,meshtoon_vert:ST,meshtoon_frag:MT,points_vert:wT,points_frag:TT,shadow_vert:ET,shadow_frag:AT,sprite_vert:CT,sprite_frag:RT},Le={common:{diffuse:{value:new xt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new xt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new xt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new xt(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},vs={basic:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},specular:{value:new xt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:qn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:qn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new xt(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:qn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:qn([Le.points,Le.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:qn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:qn([Le.common,Le.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:qn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:qn([Le.sprite,Le.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:qn([Le.common,Le.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:qn([Le.lights,Le.fog,{color:{value:new xt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};vs.physical={uniforms:qn([vs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new xt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new xt(0)},specularColor:{value:new xt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var rh={r:0,b:0,g:0},PT=new en,ov=new et;ov.set(-1,0,0,0,1,0,0,0,1);function IT(n,e,t,i,s,r){let o=new xt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(b){let E=b.isScene===!0?b.background:null;if(E&&E.isTexture){let S=b.backgroundBlurriness>0;E=e.get(E,S)}return E}function p(b){let E=!1,S=d(b);S===null?_(o,a):S&&S.isColor&&(_(S,1),E=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(b,E){let S=d(E);S&&S.isCubeTexture?(c===void 0&&(c=new Ui(new Ko(1,1,1),new Mi({name:"BackgroundCubeMaterial",uniforms:Zr(vs.backgroundCube.uniforms),vertexShader:vs.backgroundCube.vertexShader,fragmentShader:vs.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(PT.makeRotationFromEuler(E.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ov),c.material.toneMapped=yt.getTransfer(S.colorSpace)!==Pt,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Ui(new rl(2,2),new Mi({name:"BackgroundMaterial",uniforms:Zr(vs.background.uniforms),vertexShader:vs.background.vertexShader,fragmentShader:vs.background.fragmentShader,side:vr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=yt.getTransfer(S.colorSpace)!==Pt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function _(b,E){b.getRGB(rh,Kd(n)),t.buffers.color.setClear(rh.r,rh.g,rh.b,E,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,E=1){o.set(b),a=E,_(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,_(o,a)},render:p,addToRenderList:y,dispose:g}}function LT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,k,V,F,H){let Y=!1,G=f(L,F,V,k);r!==G&&(r=G,c(r.object)),Y=d(L,F,V,H),Y&&p(L,F,V,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(L,k,V,F),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,k,V,F){let H=F.wireframe===!0,Y=i[k.id];Y===void 0&&(Y={},i[k.id]=Y);let G=L.isInstancedMesh===!0?L.id:0,oe=Y[G];oe===void 0&&(oe={},Y[G]=oe);let Z=oe[V.id];Z===void 0&&(Z={},oe[V.id]=Z);let Q=Z[H];return Q===void 0&&(Q=h(l()),Z[H]=Q),Q}function h(L){let k=[],V=[],F=[];for(let H=0;H<t;H++)k[H]=0,V[H]=0,F[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:V,attributeDivisors:F,object:L,attributes:{},index:null}}function d(L,k,V,F){let H=r.attributes,Y=k.attributes,G=0,oe=V.getAttributes();for(let Z in oe)if(oe[Z].location>=0){let se=H[Z],fe=Y[Z];if(fe===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;G++}return r.attributesNum!==G||r.index!==F}function p(L,k,V,F){let H={},Y=k.attributes,G=0,oe=V.getAttributes();for(let Z in oe)if(oe[Z].location>=0){let se=Y[Z];se===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[Z]=fe,G++}r.attributes=H,r.attributesNum=G,r.index=F}function y(){let L=r.newAttributes;for(let k=0,V=L.length;k<V;k++)L[k]=0}function _(L){g(L,0)}function g(L,k){let V=r.newAttributes,F=r.enabledAttributes,H=r.attributeDivisors;V[L]=1,F[L]===0&&(n.enableVertexAttribArray(L),F[L]=1),H[L]!==k&&(n.vertexAttribDivisor(L,k),H[L]=k)}function b(){let L=r.newAttributes,k=r.enabledAttributes;for(let V=0,F=k.length;V<F;V++)k[V]!==L[V]&&(n.disableVertexAttribArray(V),k[V]=0)}function E(L,k,V,F,H,Y,G){G===!0?n.vertexAttribIPointer(L,k,V,H,Y):n.vertexAttribPointer(L,k,V,F,H,Y)}function S(L,k,V,F){y();let H=F.attributes,Y=V.getAttributes(),G=k.defaultAttributeValues;for(let oe in Y){let Z=Y[oe];if(Z.location>=0){let Q=H[oe];if(Q===void 0&&(oe==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),oe==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let se=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ve=he.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===Mu;if(Q.isInterleavedBufferAttribute){let Se=Q.data,We=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,ot=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Ve=0;Ve<Z.locationSize;Ve++)g(Z.location+Ve,Se.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Ve=0;Ve<Z.locationSize;Ve++)_(Z.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ve=0;Ve<Z.locationSize;Ve++)E(Z.location+Ve,fe/Z.locationSize,me,se,We*ve,(ot+fe/Z.locationSize*Ve)*ve,Ae)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<Z.locationSize;Se++)g(Z.location+Se,Q.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<Z.locationSize;Se++)_(Z.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<Z.locationSize;Se++)E(Z.location+Se,fe/Z.locationSize,me,se,fe*ve,fe/Z.locationSize*Se*ve,Ae)}}else if(G!==void 0){let se=G[oe];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(Z.location,se);break;case 3:n.vertexAttrib3fv(Z.location,se);break;case 4:n.vertexAttrib4fv(Z.location,se);break;default:n.vertexAttrib1fv(Z.location,se)}}}}b()}function P(){B();for(let L in i){let k=i[L];for(let V in k){let F=k[V];for(let H in F){let Y=F[H];for(let G in Y)u(Y[G].object),delete Y[G];delete F[H]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let k=i[L.id];for(let V in k){let F=k[V];for(let H in F){let Y=F[H];for(let G in Y)u(Y[G].object),delete Y[G];delete F[H]}}delete i[L.id]}function v(L){for(let k in i){let V=i[k];for(let F in V){let H=V[F];if(H[L.id]===void 0)continue;let Y=H[L.id];for(let G in Y)u(Y[G].object),delete Y[G];delete H[L.id]}}}function A(L){for(let k in i){let V=i[k],F=L.isInstancedMesh===!0?L.id:0,H=V[F];if(H!==void 0){for(let Y in H){let G=H[Y];for(let oe in G)u(G[oe].object),delete G[oe];delete H[Y]}delete V[F],Object.keys(V).length===0&&delete i[k]}}}function B(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:N,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:A,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:_,disableUnusedAttributes:b}}function DT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function NT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Qi&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let A=v===ji&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Ti&&v!==Ji&&!A&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),_=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:_,maxAttributes:g,maxVertexUniforms:b,maxVaryings:E,maxFragmentUniforms:S,maxSamples:P,samples:C}}function FT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new yi,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,y=f.clipIntersection,_=f.clipShadows,g=n.get(f);if(!s||p===null||p.length===0||r&&!_)r?u(null):c();else{let b=r?0:i,E=b*4,S=g.clippingState||null;l.value=S,S=u(p,h,E,d);for(let P=0;P!==E;++P)S[P]=t[P];g.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let y=f!==null?f.length:0,_=null;if(y!==0){if(_=l.value,p!==!0||_===null){let g=d+y*4,b=h.matrixWorldInverse;a.getNormalMatrix(b),(_===null||_.length<g)&&(_=new Float32Array(g));for(let E=0,S=d;E!==y;++E,S+=4)o.copy(f[E]).applyMatrix4(b,a),o.normal.toArray(_,S),_[S+3]=o.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,_}}var yl=class extends bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new nl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ko(5,5,5),r=new Mi({name:"CubemapFromEquirect",uniforms:Zr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ti,blending:qr});r.uniforms.tEquirect.value=t;let o=new Ui(s,r),a=t.minFilter;return t.minFilter===Os&&(t.minFilter=zn),new jo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},B0=256,UT=3,OT=20,av=256,lv=16,BT=3,kT=new K,zT=new xt,ah=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new jo(1,10,null),this._boxMesh=new Ui(new Ko(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=kT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(zT));let _=new jo(i,s,u);return _.position.copy(a),_.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=G0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=z0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(B0,Yd(e))}_fromTexture(e,t){e.mapping===Yr||e.mapping===na?this._setSize(e.image.length===0?B0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=k0(e,!1,!1),i=Math.log2(e)-UT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=k0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Yr||e.mapping===na?(this._cubemapMaterial===null&&(this._cubemapMaterial=G0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=z0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=GT(),this._integrationMaterial=VT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/lv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-BT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(av*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=HT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function k0(n,e,t){return new yl(n,{minFilter:Os,generateMipmaps:e,type:ji,colorSpace:Xa,depthBuffer:t})}function xl(n,e,t){return new Mi({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ti,blending:qr,depthTest:!1,depthWrite:!1})}function GT(){return xl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${av}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function VT(){return xl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:lv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function HT(){return xl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${OT}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function z0(){return xl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function G0(){return xl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function WT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===xu||d===bu)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let y=new yl(p.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===xu||d===bu,y=d===Yr||d===na;if(p||y){let _=t.get(h),g=_!==void 0?_.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==g)return i===null&&(i=new ah(n)),_=p?i.fromEquirectangular(h,_):i.fromCubemap(h,_),_.texture.pmremVersion=h.pmremVersion,t.set(h,_),_.texture;if(_!==void 0)return _.texture;{let b=h.image;return p&&b&&b.height>0||y&&b&&l(b)?(i===null&&(i=new ah(n)),_=p?i.fromEquirectangular(h):i.fromCubemap(h),_.texture.pmremVersion=h.pmremVersion,t.set(h,_),h.addEventListener("dispose",u),_.texture):null}}}return h}function a(h,d){return d===xu?h.mapping=Yr:d===bu&&(h.mapping=na),h}function l(h){let d=0,p=6;for(let y=0;y<p;y++)h[y]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function qT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Va("WebGLRenderer: "+i+" extension not supported."),s}}}function XT(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let _ in p.attributes)e.remove(p.attributes[_]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(e.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(p){let y=p.attributes;for(let _ in y)e.update(y[_],n.ARRAY_BUFFER)}function f(p){let y=p.index,_=p.attributes.position,g=0;if(_===void 0)return;let b=y!==null?y.array.length:_.array.length/3-1,E=_.count>=65535?el:Qa,S=new E(Math.ceil(b/3)*6,1),P=S.array;if(y!==null){let v=y.array;g=y.version;for(let A=0,B=0;A<b;A+=3){let N=v[A+0],L=v[A+1],k=v[A+2];P[B++]=N,P[B++]=L,P[B++]=L,P[B++]=k,P[B++]=k,P[B++]=N}}else{g=_.version;for(let v=0,A=0;v<b;v+=3){let B=v+0,N=v+1,L=v+2;P[A++]=B,P[A++]=N,P[A++]=N,P[A++]=L,P[A++]=L,P[A++]=B}}S.version=g;let C=r.get(p);C&&e.remove(C),r.set(p,S)}function h(p){let y=r.get(p);if(y){let _=p.index;_!==null&&y.version<_.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function YT(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let y=0;for(let _=0;_<d;_++)y+=h[_];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function $T(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function ZT(n,e,t){let i=new WeakMap,s=new tn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let B=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",B)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],E=0;d===!0&&(E=1),p===!0&&(E=2),y===!0&&(E=3);let S=a.attributes.position.count*E,P=1;S>e.maxTextureSize&&(P=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*P*4*f),v=new Ka(C,S,P,f);v.type=Ji,v.needsUpdate=!0;let A=E*4;for(let N=0;N<f;N++){let L=_[N],k=g[N],V=b[N],F=S*P*4*N;for(let H=0;H<L.count;H++){let Y=H*A;d===!0&&(s.fromBufferAttribute(L,H),C[F+Y+0]=s.x,C[F+Y+1]=s.y,C[F+Y+2]=s.z,C[F+Y+3]=0),p===!0&&(s.fromBufferAttribute(k,H),C[F+Y+4]=s.x,C[F+Y+5]=s.y,C[F+Y+6]=s.z,C[F+Y+7]=0),y===!0&&(s.fromBufferAttribute(V,H),C[F+Y+8]=s.x,C[F+Y+9]=s.y,C[F+Y+10]=s.z,C[F+Y+11]=V.itemSize===4?s.w:1)}}h={count:f,texture:v,size:new it(S,P)},i.set(a,h),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function KT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var JT={[Td]:"LINEAR_TONE_MAPPING",[Ed]:"REINHARD_TONE_MAPPING",[Ad]:"CINEON_TONE_MAPPING",[Cd]:"ACES_FILMIC_TONE_MAPPING",[Pd]:"AGX_TONE_MAPPING",[Id]:"NEUTRAL_TONE_MAPPING",[Rd]:"CUSTOM_TONE_MAPPING"};function jT(n,e,t,i,s,r){let o=new bi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new ms;u.setAttribute("position",new ri([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ri([0,2,0,0,2,0],2));let f=new ru({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Ui(u,f),d=new vu(-1,1,1,-1,0,1),p=null,y=null,_=!1,g,b=null,E=[],S=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let v=0;v<E.length;v++){let A=E[v];A.setSize&&A.setSize(P,C)}},this.setEffects=function(P){E=P,S=E.length>0&&E[0].isRenderPass===!0;let C=o.width,v=o.height;E.length>0&&a===null&&(a=new bi(C,v,{type:ji,depthBuffer:!1,stencilBuffer:!1}),l=new bi(C,v,{type:ji,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&E.some(B=>B.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new Us(C,v),r===!0&&(c.format=Bs,c.type=$r)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let B=0;B<E.length;B++){let N=E[B];N.setSize&&N.setSize(C,v),A&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(P,C){if(_||P.toneMapping===gs&&E.length===0)return!1;if(b=C,C!==null){let v=C.width,A=C.height;(o.width!==v||o.height!==A)&&this.setSize(v,A)}return S===!1&&P.setRenderTarget(o),g=P.toneMapping,P.toneMapping=gs,!0},this.hasRenderPass=function(){return S},this.end=function(P,C){P.toneMapping=g,_=!0;let v=o,A=a;for(let B=0;B<E.length;B++){let N=E[B];N.enabled!==!1&&(N.render(P,A,v,C),N.needsSwap!==!1&&(v=A,A=A===a?l:a))}if(p!==P.outputColorSpace||y!==P.toneMapping){p=P.outputColorSpace,y=P.toneMapping,f.defines={},yt.getTransfer(p)===Pt&&(f.defines.SRGB_TRANSFER="");let B=JT[y];B&&(f.defines[B]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=v.texture,P.setRenderTarget(b),P.render(h,d),b=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var cv=new oi,uv=new Us(1,1),hv=new il(1),fv=new Ka,dv=new jc,pv=new nl,V0=[],H0=[],W0=new Float32Array(16),q0=new Float32Array(9),X0=new Float32Array(4);function oa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=V0[s];if(r===void 0&&(r=new Float32Array(s),V0[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Cn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Rn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function ch(n,e){let t=H0[e];t===void 0&&(t=new Int32Array(e),H0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function QT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function eE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2fv(this.addr,e),Rn(t,e)}}function tE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;n.uniform3fv(this.addr,e),Rn(t,e)}}function nE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4fv(this.addr,e),Rn(t,e)}}function iE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;X0.set(i),n.uniformMatrix2fv(this.addr,!1,X0),Rn(t,i)}}function sE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;q0.set(i),n.uniformMatrix3fv(this.addr,!1,q0),Rn(t,i)}}function rE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;W0.set(i),n.uniformMatrix4fv(this.addr,!1,W0),Rn(t,i)}}function oE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function aE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2iv(this.addr,e),Rn(t,e)}}function lE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3iv(this.addr,e),Rn(t,e)}}function cE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4iv(this.addr,e),Rn(t,e)}}function uE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function hE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2uiv(this.addr,e),Rn(t,e)}}function fE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3uiv(this.addr,e),Rn(t,e)}}function dE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4uiv(this.addr,e),Rn(t,e)}}function uh(n){return n.version===0&&(n.compareFunction=Hd,n.needsUpdate=!0),n}function pE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=uh(uv):r=cv,t.setTexture2D(e||r,s)}function mE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||dv,s)}function gE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=uh(hv):r=pv,t.setTextureCube(e||r,s)}function _E(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||fv,s)}function vE(n){switch(n){case 5126:return QT;case 35664:return eE;case 35665:return tE;case 35666:return nE;case 35674:return iE;case 35675:return sE;case 35676:return rE;case 5124:case 35670:return oE;case 35667:case 35671:return aE;case 35668:case 35672:return lE;case 35669:case 35673:return cE;case 5125:return uE;case 36294:return hE;case 36295:return fE;case 36296:return dE;case 35678:case 36198:case 36298:case 36306:case 35682:return pE;case 35679:case 36299:case 36307:return mE;case 35680:case 36300:case 36308:case 36293:return gE;case 36289:case 36303:case 36311:case 36292:return _E}}function yE(n,e){n.uniform1fv(this.addr,e)}function xE(n,e){let t=oa(e,this.size,2);n.uniform2fv(this.addr,t)}function bE(n,e){let t=oa(e,this.size,3);n.uniform3fv(this.addr,t)}function SE(n,e){let t=oa(e,this.size,4);n.uniform4fv(this.addr,t)}function ME(n,e){let t=oa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function wE(n,e){let t=oa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function TE(n,e){let t=oa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function EE(n,e){n.uniform1iv(this.addr,e)}function AE(n,e){n.uniform2iv(this.addr,e)}function CE(n,e){n.uniform3iv(this.addr,e)}function RE(n,e){n.uniform4iv(this.addr,e)}function PE(n,e){n.uniform1uiv(this.addr,e)}function IE(n,e){n.uniform2uiv(this.addr,e)}function LE(n,e){n.uniform3uiv(this.addr,e)}function DE(n,e){n.uniform4uiv(this.addr,e)}function NE(n,e,t){let i=this.cache,s=e.length,r=ch(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=uh(uv):o=cv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function FE(n,e,t){let i=this.cache,s=e.length,r=ch(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||dv,r[o])}function UE(n,e,t){let i=this.cache,s=e.length,r=ch(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=uh(hv):o=pv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function OE(n,e,t){let i=this.cache,s=e.length,r=ch(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||fv,r[o])}function BE(n){switch(n){case 5126:return yE;case 35664:return xE;case 35665:return bE;case 35666:return SE;case 35674:return ME;case 35675:return wE;case 35676:return TE;case 5124:case 35670:return EE;case 35667:case 35671:return AE;case 35668:case 35672:return CE;case 35669:case 35673:return RE;case 5125:return PE;case 36294:return IE;case 36295:return LE;case 36296:return DE;case 35678:case 36198:case 36298:case 36306:case 35682:return NE;case 35679:case 36299:case 36307:return FE;case 35680:case 36300:case 36308:case 36293:return UE;case 36289:case 36303:case 36311:case 36292:return OE}}var np=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=vE(t.type)}},ip=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=BE(t.type)}},sp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},ep=/(\w+)(\])?(\[|\.)?/g;function Y0(n,e){n.seq.push(e),n.map[e.id]=e}function kE(n,e,t){let i=n.name,s=i.length;for(ep.lastIndex=0;;){let r=ep.exec(i),o=ep.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Y0(t,c===void 0?new np(a,n,e):new ip(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new sp(a),Y0(t,f)),t=f}}}var ra=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);kE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function $0(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var zE=37297,GE=0;function VE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Z0=new et;function HE(n){yt._getMatrix(Z0,yt.workingColorSpace,n);let e=`mat3( ${Z0.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(n)){case Ya:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function K0(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+VE(n.getShaderSource(e),a)}else return r}function WE(n,e){let t=HE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var qE={[Td]:"Linear",[Ed]:"Reinhard",[Ad]:"Cineon",[Cd]:"ACESFilmic",[Pd]:"AgX",[Id]:"Neutral",[Rd]:"Custom"};function XE(n,e){let t=qE[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var oh=new K;function YE(){yt.getLuminanceCoefficients(oh);let n=oh.x.toFixed(4),e=oh.y.toFixed(4),t=oh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function $E(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(vl).join(`
`)}function ZE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function KE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function vl(n){return n!==""}function J0(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function j0(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var JE=/^[ \t]*#include +<([\w\d./]+)>/gm;function rp(n){return n.replace(JE,jE)}function jE(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return rp(t)}var QE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Q0(n){return n.replace(QE,eA)}function eA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function ev(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var tA={[cl]:"SHADOWMAP_TYPE_PCF",[ea]:"SHADOWMAP_TYPE_VSM"};function nA(n){return tA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var iA={[na]:"ENVMAP_MODE_REFRACTION"};function sA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":iA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var rA={[wd]:"ENVMAP_BLENDING_MULTIPLY",[g0]:"ENVMAP_BLENDING_MIX",[_0]:"ENVMAP_BLENDING_ADD"};function oA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":rA[n.combine]||"ENVMAP_BLENDING_NONE"}function aA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=nA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=sA(t),f=oA(t),h=$E(t),d=ZE(r),p=s.createProgram(),y,_,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(vl).join(`
`),y.length>0&&(y+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(vl).join(`
`),_.length>0&&(_+=`
`)):(y=[ev(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(vl).join(`
`),_=[ev(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==gs?"#define TONE_MAPPING":"",t.toneMapping!==gs?ht.tonemapping_pars_fragment:"",t.toneMapping!==gs?XE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,WE("linearToOutputTexel",t.outputColorSpace),YE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(vl).join(`
`)),o=rp(o),o=J0(o,t),o=j0(o,t),a=rp(a),a=J0(a,t),a=j0(a,t),o=Q0(o),a=Q0(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,_=["#define varying in",t.glslVersion===Wd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Wd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let b=g+y+o,E=g+_+a,S=$0(s,s.VERTEX_SHADER,b),P=$0(s,s.FRAGMENT_SHADER,E);s.attachShader(p,S),s.attachShader(p,P),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function C(N){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",k=s.getShaderInfoLog(S)||"",V=s.getShaderInfoLog(P)||"",F=L.trim(),H=k.trim(),Y=V.trim(),G=!0,oe=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,P);else{let Z=K0(s,S,"vertex"),Q=K0(s,P,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+F+`
`+Z+`
`+Q)}else F!==""?$e("WebGLProgram: Program Info Log:",F):(H===""||Y==="")&&(oe=!1);oe&&(N.diagnostics={runnable:G,programLog:F,vertexShader:{log:H,prefix:y},fragmentShader:{log:Y,prefix:_}})}s.deleteShader(S),s.deleteShader(P),v=new ra(s,p),A=KE(s,p)}let v;this.getUniforms=function(){return v===void 0&&C(this),v};let A;this.getAttributes=function(){return A===void 0&&C(this),A};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(p,zE)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=GE++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=P,this}var lA=0,op=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new ap(e),t.set(e,i)),i}},ap=class{constructor(e){this.id=lA++,this.code=e,this.usedTimes=0}};function cA(n){return n===yr||n===ml||n===gl}function uA(n,e,t,i,s,r){let o=new Ja,a=new op,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,A,B,N,L,k){let V=N.fog,F=L.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?N.environment:null,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||H,Y),oe=h[v.type],Z=i.precision;v.precision!==null&&(Z=i.getMaxPrecision(v.precision),Z!==v.precision&&$e("WebGLProgram.getParameters:",v.precision,"not supported, using",Z,"instead."));let Q=F.morphAttributes.position||F.morphAttributes.normal||F.morphAttributes.color,se=Q!==void 0?Q.length:0,fe=0;F.morphAttributes.position!==void 0&&(fe=1),F.morphAttributes.normal!==void 0&&(fe=2),F.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ve;if(oe){let Ce=vs[oe];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),lt=a.getFragmentShaderStage(v);a.update(v,Ce,lt),me=Ce.id,ve=lt.id}let Ae=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),We=L.isInstancedMesh===!0,ot=L.isBatchedMesh===!0,Ve=!!v.map,ft=!!v.matcap,ct=!!G,st=ct&&G.isPMREMTexture===!0,Zt=!!v.aoMap,zt=!!v.lightMap,dn=!!v.bumpMap&&v.wireframe===!1,Ft=!!v.normalMap,In=!!v.displacementMap,bt=!!v.emissiveMap,Mn=!!v.metalnessMap,nn=!!v.roughnessMap,pn=v.anisotropy>0,O=v.clearcoat>0,Re=v.diffuseRoughness>0,Ze=v.dispersion>0,at=v.retroreflectivity>0,Me=v.iridescence>0,Ot=v.sheen>0,ze=v.transmission>0,Ye=pn&&!!v.anisotropyMap,R=O&&!!v.clearcoatMap,M=O&&!!v.clearcoatNormalMap,q=O&&!!v.clearcoatRoughnessMap,ue=Re&&!!v.diffuseRoughnessMap,ae=Me&&!!v.iridescenceMap,_e=Me&&!!v.iridescenceThicknessMap,ye=Ot&&!!v.sheenColorMap,te=Ot&&!!v.sheenRoughnessMap,ie=!!v.specularMap,pe=!!v.specularColorMap,U=!!v.specularIntensityMap,re=ze&&!!v.transmissionMap,ne=ze&&!!v.thicknessMap,we=!!v.gradientMap,ge=!!v.alphaMap,be=v.alphaTest>0,He=!!v.alphaHash,Je=!!v.extensions,ce=gs;v.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Oe=st?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,je={shaderID:oe,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:Z,batching:ot,batchingColor:ot&&L._colorsTexture!==null,instancing:We,instancingColor:We&&L.instanceColor!==null,instancingMorph:We&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:yt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ve,matcap:ft,envMap:ct,envMapMode:ct&&G.mapping,envMapPMREM:st,envMapMaxLod:st?Oe.length-1:null,envMapSize:st?Oe[0].width:null,aoMap:Zt,lightMap:zt,bumpMap:dn,normalMap:Ft,displacementMap:In,emissiveMap:bt,normalMapObjectSpace:Ft&&v.normalMapType===x0,normalMapTangentSpace:Ft&&v.normalMapType===zd,packedNormalMap:Ft&&v.normalMapType===zd&&cA(v.normalMap.format),metalnessMap:Mn,roughnessMap:nn,anisotropy:pn,anisotropyMap:Ye,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ze,retroreflection:at,iridescence:Me,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:Ot,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:pe,specularIntensityMap:U,transmission:ze,transmissionMap:re,thicknessMap:ne,gradientMap:we,opaque:v.transparent===!1&&v.blending===ta&&v.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:He,combine:v.combine,mapUv:Ve&&d(v.map.channel),aoMapUv:Zt&&d(v.aoMap.channel),lightMapUv:zt&&d(v.lightMap.channel),bumpMapUv:dn&&d(v.bumpMap.channel),normalMapUv:Ft&&d(v.normalMap.channel),displacementMapUv:In&&d(v.displacementMap.channel),emissiveMapUv:bt&&d(v.emissiveMap.channel),metalnessMapUv:Mn&&d(v.metalnessMap.channel),roughnessMapUv:nn&&d(v.roughnessMap.channel),anisotropyMapUv:Ye&&d(v.anisotropyMap.channel),clearcoatMapUv:R&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(v.sheenRoughnessMap.channel),specularMapUv:ie&&d(v.specularMap.channel),specularColorMapUv:pe&&d(v.specularColorMap.channel),specularIntensityMapUv:U&&d(v.specularIntensityMap.channel),transmissionMapUv:re&&d(v.transmissionMap.channel),thicknessMapUv:ne&&d(v.thicknessMap.channel),alphaMapUv:ge&&d(v.alphaMap.channel),vertexTangents:!!F.attributes.tangent&&(Ft||pn),vertexNormals:!!F.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!F.attributes.color&&F.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!F.attributes.uv&&(Ve||ge),fog:!!V,useFog:v.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||F.attributes.normal===void 0&&Ft===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Se,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:F.attributes.position!==void 0,morphTargets:F.morphAttributes.position!==void 0,morphNormals:F.morphAttributes.normal!==void 0,morphColors:F.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ve&&v.map.isVideoTexture===!0&&yt.getTransfer(v.map.colorSpace)===Pt,decodeVideoTextureEmissive:bt&&v.emissiveMap.isVideoTexture===!0&&yt.getTransfer(v.emissiveMap.colorSpace)===Pt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Oi,flipSided:v.side===ti,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&v.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function y(v){let A=[];if(v.shaderID?A.push(v.shaderID):(A.push(v.customVertexShaderID),A.push(v.customFragmentShaderID)),v.defines!==void 0)for(let B in v.defines)A.push(B),A.push(v.defines[B]);return v.isRawShaderMaterial===!1&&(_(A,v),g(A,v),A.push(n.outputColorSpace)),A.push(v.customProgramCacheKey),A.join()}function _(v,A){v.push(A.precision),v.push(A.outputColorSpace),v.push(A.envMapMode),v.push(A.envMapPMREM),v.push(A.envMapMaxLod),v.push(A.envMapSize),v.push(A.mapUv),v.push(A.alphaMapUv),v.push(A.lightMapUv),v.push(A.aoMapUv),v.push(A.bumpMapUv),v.push(A.normalMapUv),v.push(A.displacementMapUv),v.push(A.emissiveMapUv),v.push(A.metalnessMapUv),v.push(A.roughnessMapUv),v.push(A.anisotropyMapUv),v.push(A.clearcoatMapUv),v.push(A.clearcoatNormalMapUv),v.push(A.clearcoatRoughnessMapUv),v.push(A.diffuseRoughnessMapUv),v.push(A.iridescenceMapUv),v.push(A.iridescenceThicknessMapUv),v.push(A.sheenColorMapUv),v.push(A.sheenRoughnessMapUv),v.push(A.specularMapUv),v.push(A.specularColorMapUv),v.push(A.specularIntensityMapUv),v.push(A.transmissionMapUv),v.push(A.thicknessMapUv),v.push(A.combine),v.push(A.fogExp2),v.push(A.sizeAttenuation),v.push(A.morphTargetsCount),v.push(A.numSunLights),v.push(A.numDirLights),v.push(A.numPointLights),v.push(A.numSpotLights),v.push(A.numSpotLightMaps),v.push(A.numHemiLights),v.push(A.numRectAreaLights),v.push(A.numSunLightShadows),v.push(A.numDirLightShadows),v.push(A.numPointLightShadows),v.push(A.numSpotLightShadows),v.push(A.numSpotLightShadowsWithMaps),v.push(A.numLightProbes),v.push(A.numLightProbeGrids),v.push(A.shadowMapType),v.push(A.toneMapping),v.push(A.numClippingPlanes),v.push(A.numClipIntersection),v.push(A.depthPacking)}function g(v,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let A=h[v.type],B;if(A){let N=vs[A];B=F0.clone(N.uniforms)}else B=v.uniforms;return B}function E(v,A){let B=u.get(A);return B!==void 0?++B.usedTimes:(B=new aA(n,A,v,s),c.push(B),u.set(A,B)),B}function S(v){if(--v.usedTimes===0){let A=c.indexOf(v);c[A]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function P(v){a.remove(v)}function C(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:b,acquireProgram:E,releaseProgram:S,releaseShaderCache:P,programs:c,dispose:C}}function hA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function fA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function tv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function nv(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,y,_,g){let b=n[e];return b===void 0?(b={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:_,group:g},n[e]=b):(b.id=h.id,b.object=h,b.geometry=d,b.material=p,b.materialVariant=o(h),b.groupOrder=y,b.renderOrder=h.renderOrder,b.z=_,b.group=g),e++,b}function l(h,d,p,y,_,g,b){b.reversedDepth===!0&&(_=-_);let E=a(h,d,p,y,_,g);p.transmission>0?i.push(E):p.transparent===!0?s.push(E):t.push(E)}function c(h,d,p,y,_,g){let b=a(h,d,p,y,_,g);p.transmission>0?i.unshift(b):p.transparent===!0?s.unshift(b):t.unshift(b)}function u(h,d){t.length>1&&t.sort(h||fA),i.length>1&&i.sort(d||tv),s.length>1&&s.sort(d||tv)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function dA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new nv,n.set(i,[o])):s>=r.length?(o=new nv,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function pA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new K,color:new xt};break;case"SpotLight":t={position:new K,direction:new K,color:new xt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new K,color:new xt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new K,skyColor:new xt,groundColor:new xt};break;case"RectAreaLight":t={color:new xt,position:new K,halfWidth:new K,halfHeight:new K};break}return n[e.id]=t,t}}}function mA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var gA=0;function _A(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function vA(n){let e=new pA,t=mA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new K);let s=new K,r=new en,o=new en;function a(c){let u=0,f=0,h=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,p=0,y=0,_=0,g=0,b=0,E=0,S=0,P=0,C=0,v=0,A=0,B=0,N=0;c.sort(_A);for(let k=0,V=c.length;k<V;k++){let F=c[k],H=F.color,Y=F.intensity,G=F.distance,oe=null;if(F.shadow&&F.shadow.map&&(F.shadow.map.texture.format===yr?oe=F.shadow.map.texture:oe=F.shadow.map.depthTexture||F.shadow.map.texture),F.isAmbientLight)u+=H.r*Y,f+=H.g*Y,h+=H.b*Y;else if(F.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(F.sh.coefficients[Z],Y);N++}else if(F.isSunLight){let Z=e.get(F);if(Z.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let Q=F.shadow,se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=se,i.sunShadowMap[p]=oe;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[y+he]=Q.getMatrix(he),i.sunShadowCascade[y+he]=Q._cascadeData[he];y+=fe,p++}i.sun[d]=Z,d++}else if(F.isDirectionalLight){let Z=e.get(F);if(Z.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let Q=F.shadow,se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[_]=se,i.directionalShadowMap[_]=oe,i.directionalShadowMatrix[_]=F.shadow.matrix,P++}i.directional[_]=Z,_++}else if(F.isSpotLight){let Z=e.get(F);Z.position.setFromMatrixPosition(F.matrixWorld),Z.color.copy(H).multiplyScalar(Y),Z.distance=G,Z.coneCos=Math.cos(F.angle),Z.penumbraCos=Math.cos(F.angle*(1-F.penumbra)),Z.decay=F.decay,i.spot[b]=Z;let Q=F.shadow;if(F.map&&(i.spotLightMap[A]=F.map,A++,Q.updateMatrices(F),F.castShadow&&B++),i.spotLightMatrix[b]=Q.matrix,F.castShadow){let se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[b]=se,i.spotShadowMap[b]=oe,v++}b++}else if(F.isRectAreaLight){let Z=e.get(F);Z.color.copy(H).multiplyScalar(Y),Z.halfWidth.set(F.width*.5,0,0),Z.halfHeight.set(0,F.height*.5,0),i.rectArea[E]=Z,E++}else if(F.isPointLight){let Z=e.get(F);if(Z.color.copy(F.color).multiplyScalar(F.intensity),Z.distance=F.distance,Z.decay=F.decay,F.castShadow){let Q=F.shadow,se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[g]=se,i.pointShadowMap[g]=oe,i.pointShadowMatrix[g]=F.shadow.matrix,C++}i.point[g]=Z,g++}else if(F.isHemisphereLight){let Z=e.get(F);Z.skyColor.copy(F.color).multiplyScalar(Y),Z.groundColor.copy(F.groundColor).multiplyScalar(Y),i.hemi[S]=Z,S++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let L=i.hash;(L.sunLength!==d||L.directionalLength!==_||L.pointLength!==g||L.spotLength!==b||L.rectAreaLength!==E||L.hemiLength!==S||L.numSunShadows!==p||L.numDirectionalShadows!==P||L.numPointShadows!==C||L.numSpotShadows!==v||L.numSpotMaps!==A||L.numLightProbes!==N)&&(i.sun.length=d,i.directional.length=_,i.spot.length=b,i.rectArea.length=E,i.point.length=g,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+A-B,i.spotLightMap.length=A,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=N,L.sunLength=d,L.directionalLength=_,L.pointLength=g,L.spotLength=b,L.rectAreaLength=E,L.hemiLength=S,L.numSunShadows=p,L.numDirectionalShadows=P,L.numPointShadows=C,L.numSpotShadows=v,L.numSpotMaps=A,L.numLightProbes=N,i.version=gA++)}function l(c,u){let f=0,h=0,d=0,p=0,y=0,_=0,g=u.matrixWorldInverse;for(let b=0,E=c.length;b<E;b++){let S=c[b];if(S.isSunLight){let P=i.sun[f];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),f++}else if(S.isDirectionalLight){let P=i.directional[h];P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(g),h++}else if(S.isSpotLight){let P=i.spot[p];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let P=i.rectArea[y];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let P=i.point[d];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),d++}else if(S.isHemisphereLight){let P=i.hemi[_];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:i}}function iv(n){let e=new vA(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function yA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new iv(n),e.set(s,[a])):r>=o.length?(a=new iv(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var xA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,bA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,SA=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],MA=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],sv=new en,_l=new K,tp=new K;function wA(n,e,t){let i=new Wr,s=new it,r=new it,o=new tn,a=new ou,l=new au,c={},u=t.maxTextureSize,f={[vr]:ti,[ti]:vr,[Oi]:Oi},h=new Mi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:xA,fragmentShader:bA}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new ms;p.setAttribute("position",new ei(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ui(p,h),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=cl;let g=this.type;this.render=function(C,v,A){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||C.length===0)return;this.type===J_&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=cl);let B=n.getRenderTarget(),N=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),k=n.state;k.setBlending(qr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let V=g!==this.type;V&&v.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(H=>H.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,H=C.length;F<H;F++){let Y=C[F],G=Y.shadow;if(G===void 0){$e("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let oe=G.getFrameExtents();s.multiply(oe),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/oe.x),s.x=r.x*oe.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/oe.y),s.y=r.y*oe.y,G.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Z,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===ea){if(Y.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new bi(s.x,s.y,{format:yr,type:ji,minFilter:zn,magFilter:zn,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new Us(s.x,s.y,Ji),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=Ns,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=On,G.map.depthTexture.magFilter=On}else Y.isPointLight?(G.map=new yl(s.x),G.map.depthTexture=new il(s.x,Ki)):(G.map=new bi(s.x,s.y),G.map.depthTexture=new Us(s.x,s.y,Ki)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=Ns,this.type===cl?(G.map.depthTexture.compareFunction=Z?Vd:Gd,G.map.depthTexture.minFilter=zn,G.map.depthTexture.magFilter=zn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=On,G.map.depthTexture.magFilter=On);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,A);let se=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:A.layers;for(let fe=0;fe<Q;fe++){let he=G.getCamera(fe);if(Y.isPointLight){let ee=G.camera,me=G.matrix,ve=Y.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),_l.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(_l),tp.copy(ee.position),tp.add(SA[fe]),ee.up.copy(MA[fe]),ee.lookAt(tp),ee.updateMatrixWorld(),me.makeTranslation(-_l.x,-_l.y,-_l.z),sv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(sv,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),k.viewport(o)}i=G.getFrustum(fe),S(v,A,he,Y,se,this.type)}G.isPointLightShadow!==!0&&this.type===ea&&b(G,A),G.needsUpdate=!1}g=this.type,_.needsUpdate=!1,n.setRenderTarget(B,N,L)};function b(C,v){let A=e.update(y);h.defines.VSM_SAMPLES!==C.blurSamples&&(h.defines.VSM_SAMPLES=C.blurSamples,d.defines.VSM_SAMPLES=C.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),C.mapPass===null?C.mapPass=new bi(s.x,s.y,{format:yr,type:ji}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),h.uniforms.shadow_pass.value=C.map.depthTexture,h.uniforms.resolution.value.set(C.map.width,C.map.height),h.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(v,null,A,h,y,null),d.uniforms.shadow_pass.value=C.mapPass.texture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(v,null,A,d,y,null)}function E(C,v,A,B){let N=null,L=A.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)N=L;else if(N=A.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let k=N.uuid,V=v.uuid,F=c[k];F===void 0&&(F={},c[k]=F);let H=F[V];H===void 0&&(H=N.clone(),F[V]=H,v.addEventListener("dispose",P)),N=H}if(N.visible=v.visible,N.wireframe=v.wireframe,B===ea?N.side=v.shadowSide!==null?v.shadowSide:v.side:N.side=v.shadowSide!==null?v.shadowSide:f[v.side],N.alphaMap=v.alphaMap,N.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,N.map=v.map,N.clipShadows=v.clipShadows,N.clippingPlanes=v.clippingPlanes,N.clipIntersection=v.clipIntersection,N.displacementMap=v.displacementMap,N.displacementScale=v.displacementScale,N.displacementBias=v.displacementBias,N.wireframeLinewidth=v.wireframeLinewidth,N.linewidth=v.linewidth,A.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let k=n.properties.get(N);k.light=A}return N}function S(C,v,A,B,N,L){if(C.visible===!1)return;if(C.layers.test(N)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===ea)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,C.matrixWorld);let F=e.update(C),H=C.material;if(Array.isArray(H)){let Y=F.groups;for(let G=0,oe=Y.length;G<oe;G++){let Z=Y[G],Q=H[Z.materialIndex];if(Q&&Q.visible){let se=E(C,Q,B,L);C.onBeforeShadow(n,C,v,A,F,se,Z),n.renderBufferDirect(A,null,F,se,C,Z),C.onAfterShadow(n,C,v,A,F,se,Z)}}}else if(H.visible){let Y=E(C,H,B,L);C.onBeforeShadow(n,C,v,A,F,Y,null),n.renderBufferDirect(A,null,F,Y,C,null),C.onAfterShadow(n,C,v,A,F,Y,null)}}let V=C.children;for(let F=0,H=V.length;F<H;F++)S(V[F],v,A,B,N,L)}function P(C){C.target.removeEventListener("dispose",P);for(let A in c){let B=c[A],N=C.target.uuid;N in B&&(B[N].dispose(),delete B[N])}}}function TA(n,e){function t(){let U=!1,re=new tn,ne=null,we=new tn(0,0,0,0);return{setMask:function(ge){ne!==ge&&!U&&(n.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){U=ge},setClear:function(ge,be,He,Je,ce){ce===!0&&(ge*=Je,be*=Je,He*=Je),re.set(ge,be,He,Je),we.equals(re)===!1&&(n.clearColor(ge,be,He,Je),we.copy(re))},reset:function(){U=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let U=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){if(re!==be){let He=e.get("EXT_clip_control");be?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),re=be;let Je=ge;ge=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(be){be?Se(n.DEPTH_TEST):We(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!U&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=I0[be]),we!==be){switch(be){case zc:n.depthFunc(n.NEVER);break;case Gc:n.depthFunc(n.ALWAYS);break;case Vc:n.depthFunc(n.LESS);break;case Wo:n.depthFunc(n.LEQUAL);break;case Hc:n.depthFunc(n.EQUAL);break;case Wc:n.depthFunc(n.GEQUAL);break;case qc:n.depthFunc(n.GREATER);break;case Xc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=be}},setLocked:function(be){U=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){U=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let U=!1,re=null,ne=null,we=null,ge=null,be=null,He=null,Je=null,ce=null;return{setTest:function(Oe){U||(Oe?Se(n.STENCIL_TEST):We(n.STENCIL_TEST))},setMask:function(Oe){re!==Oe&&!U&&(n.stencilMask(Oe),re=Oe)},setFunc:function(Oe,je,Ce){(ne!==Oe||we!==je||ge!==Ce)&&(n.stencilFunc(Oe,je,Ce),ne=Oe,we=je,ge=Ce)},setOp:function(Oe,je,Ce){(be!==Oe||He!==je||Je!==Ce)&&(n.stencilOp(Oe,je,Ce),be=Oe,He=je,Je=Ce)},setLocked:function(Oe){U=Oe},setClear:function(Oe){ce!==Oe&&(n.clearStencil(Oe),ce=Oe)},reset:function(){U=!1,re=null,ne=null,we=null,ge=null,be=null,He=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],y=null,_=!1,g=null,b=null,E=null,S=null,P=null,C=null,v=null,A=new xt(0,0,0),B=0,N=!1,L=null,k=null,V=null,F=null,H=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,oe=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(oe=parseFloat(/^WebGL (\d)/.exec(Z)[1]),G=oe>=1):Z.indexOf("OpenGL ES")!==-1&&(oe=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),G=oe>=2);let Q=null,se={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new tn().fromArray(fe),me=new tn().fromArray(he);function ve(U,re,ne,we){let ge=new Uint8Array(4),be=n.createTexture();n.bindTexture(U,be),n.texParameteri(U,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(U,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let He=0;He<ne;He++)U===n.TEXTURE_3D||U===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+He,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return be}let Ae={};Ae[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(Wo),dn(!1),Ft(vd),Se(n.CULL_FACE),Zt(qr);function Se(U){u[U]!==!0&&(n.enable(U),u[U]=!0)}function We(U){u[U]!==!1&&(n.disable(U),u[U]=!1)}function ot(U,re){return h[U]!==re?(n.bindFramebuffer(U,re),h[U]=re,U===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),U===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ve(U,re){let ne=p,we=!1;if(U){ne=d.get(re),ne===void 0&&(ne=[],d.set(re,ne));let ge=U.textures;if(ne.length!==ge.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,He=ge.length;be<He;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function ft(U){return y!==U?(n.useProgram(U),y=U,!0):!1}let ct={[Xr]:n.FUNC_ADD,[Q_]:n.FUNC_SUBTRACT,[e0]:n.FUNC_REVERSE_SUBTRACT};ct[t0]=n.MIN,ct[n0]=n.MAX;let st={[i0]:n.ZERO,[s0]:n.ONE,[r0]:n.SRC_COLOR,[Sd]:n.SRC_ALPHA,[h0]:n.SRC_ALPHA_SATURATE,[c0]:n.DST_COLOR,[a0]:n.DST_ALPHA,[o0]:n.ONE_MINUS_SRC_COLOR,[Md]:n.ONE_MINUS_SRC_ALPHA,[u0]:n.ONE_MINUS_DST_COLOR,[l0]:n.ONE_MINUS_DST_ALPHA,[f0]:n.CONSTANT_COLOR,[d0]:n.ONE_MINUS_CONSTANT_COLOR,[p0]:n.CONSTANT_ALPHA,[m0]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(U,re,ne,we,ge,be,He,Je,ce,Oe){if(U===qr){_===!0&&(We(n.BLEND),_=!1);return}if(_===!1&&(Se(n.BLEND),_=!0),U!==j_){if(U!==g||Oe!==N){if((b!==Xr||P!==Xr)&&(n.blendEquation(n.FUNC_ADD),b=Xr,P=Xr),Oe)switch(U){case ta:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yd:n.blendFunc(n.ONE,n.ONE);break;case xd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case bd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:nt("WebGLState: Invalid blending: ",U);break}else switch(U){case ta:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case xd:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case bd:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",U);break}E=null,S=null,C=null,v=null,A.set(0,0,0),B=0,g=U,N=Oe}return}ge=ge||re,be=be||ne,He=He||we,(re!==b||ge!==P)&&(n.blendEquationSeparate(ct[re],ct[ge]),b=re,P=ge),(ne!==E||we!==S||be!==C||He!==v)&&(n.blendFuncSeparate(st[ne],st[we],st[be],st[He]),E=ne,S=we,C=be,v=He),(Je.equals(A)===!1||ce!==B)&&(n.blendColor(Je.r,Je.g,Je.b,ce),A.copy(Je),B=ce),g=U,N=!1}function zt(U,re){U.side===Oi?We(n.CULL_FACE):Se(n.CULL_FACE);let ne=U.side===ti;re&&(ne=!ne),dn(ne),U.blending===ta&&U.transparent===!1?Zt(qr):Zt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let we=U.stencilWrite;a.setTest(we),we&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),bt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):We(n.SAMPLE_ALPHA_TO_COVERAGE)}function dn(U){L!==U&&(U?n.frontFace(n.CW):n.frontFace(n.CCW),L=U)}function Ft(U){U!==Z_?(Se(n.CULL_FACE),U!==k&&(U===vd?n.cullFace(n.BACK):U===K_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):We(n.CULL_FACE),k=U}function In(U){U!==V&&(G&&n.lineWidth(U),V=U)}function bt(U,re,ne){U?(Se(n.POLYGON_OFFSET_FILL),(F!==re||H!==ne)&&(F=re,H=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):We(n.POLYGON_OFFSET_FILL)}function Mn(U){U?Se(n.SCISSOR_TEST):We(n.SCISSOR_TEST)}function nn(U){U===void 0&&(U=n.TEXTURE0+Y-1),Q!==U&&(n.activeTexture(U),Q=U)}function pn(U,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+Y-1:ne=Q);let we=se[ne];we===void 0&&(we={type:void 0,texture:void 0},se[ne]=we),(we.type!==U||we.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(U,re||Ae[U]),we.type=U,we.texture=re)}function O(){let U=se[Q];U!==void 0&&U.type!==void 0&&(n.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function at(){try{n.texSubImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function Me(){try{n.texSubImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ot(){try{n.compressedTexSubImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function Ye(){try{n.texStorage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function R(){try{n.texStorage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function M(){try{n.texImage2D(...arguments)}catch(U){nt("WebGLState:",U)}}function q(){try{n.texImage3D(...arguments)}catch(U){nt("WebGLState:",U)}}function ue(U){return f[U]!==void 0?f[U]:n.getParameter(U)}function ae(U,re){f[U]!==re&&(n.pixelStorei(U,re),f[U]=re)}function _e(U){ee.equals(U)===!1&&(n.scissor(U.x,U.y,U.z,U.w),ee.copy(U))}function ye(U){me.equals(U)===!1&&(n.viewport(U.x,U.y,U.z,U.w),me.copy(U))}function te(U,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(U);we===void 0&&(we=n.getUniformBlockIndex(re,U.name),n.uniformBlockBinding(re,we,we),ne.set(U,we))}function ie(U,re,ne){let ge=c.get(re).get(U);l[ge]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,se={},h={},l={},d=new WeakMap,p=[],y=null,_=!1,g=null,b=null,E=null,S=null,P=null,C=null,v=null,A=new xt(0,0,0),B=0,N=!1,L=null,k=null,V=null,F=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:We,bindFramebuffer:ot,drawBuffers:Ve,useProgram:ft,setBlending:Zt,setMaterial:zt,setFlipSided:dn,setCullFace:Ft,setLineWidth:In,setPolygonOffset:bt,setScissorTest:Mn,activeTexture:nn,bindTexture:pn,unbindTexture:O,compressedTexImage2D:Re,compressedTexImage3D:Ze,texImage2D:M,texImage3D:q,pixelStorei:ae,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:Ye,texStorage3D:R,texSubImage2D:at,texSubImage3D:Me,compressedTexSubImage2D:Ot,compressedTexSubImage3D:ze,scissor:_e,viewport:ye,reset:pe}}function EA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,y=new FinalizationRegistry(R=>p.delete(R)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,M){return _?new OffscreenCanvas(R,M):Za("canvas")}function b(R,M,q){let ue=1,ae=Ye(R);if((ae.width>q||ae.height>q)&&(ue=q/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _e=Math.floor(ue*ae.width),ye=Math.floor(ue*ae.height);h===void 0&&(h=g(_e,ye));let te=M?g(_e,ye):h;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(R,0,0,_e,ye),$e("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+ye+")."),te}else return"data"in R&&$e("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function E(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function P(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,M,q,ue,ae,_e=!1){if(R!==null){if(n[R]!==void 0)return n[R];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let ie=_e?Ya:yt.getTransfer(ae);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Pt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(R,M){let q;return R?M===null||M===Ki||M===$r?q=n.DEPTH24_STENCIL8:M===Ji?q=n.DEPTH32F_STENCIL8:M===ia&&(q=n.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ki||M===$r?q=n.DEPTH_COMPONENT24:M===Ji?q=n.DEPTH_COMPONENT32F:M===ia&&(q=n.DEPTH_COMPONENT16),q}function A(R,M){return E(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==zn?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function B(R){let M=new WeakRef(R);i.get(R).__ref=M,p.add(M),y.register(R,M,M)}function N(R){let M=i.get(R).__ref;M!==void 0&&(p.delete(M),y.unregister(M))}function L(R){V(R.target)}function k(R){F(R.target)}function V(R){R.removeEventListener("dispose",L),N(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function F(R){R.removeEventListener("dispose",k),N(R),oe(R)}function H(){for(let R of p){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?F(M):V(M))}p.clear(),f.clear()}function Y(R){let M=i.get(R);if(M.__webglInit===void 0)return;let q=R.source,ue=d.get(q);if(ue){let ae=ue[M.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(R),Object.keys(ue).length===0&&d.delete(q)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let q=R.source,ue=d.get(q);delete ue[M.__cacheKey],o.memory.textures--}function oe(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&V(q),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(M.__webglFramebuffer[ae]))for(let _e=0;_e<M.__webglFramebuffer[ae].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[ae][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[ae]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[ae])}else{if(Array.isArray(M.__webglFramebuffer))for(let ae=0;ae<M.__webglFramebuffer.length;ae++)n.deleteFramebuffer(M.__webglFramebuffer[ae]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ae=0;ae<M.__webglColorRenderbuffer.length;ae++)M.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[ae]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let ae=0,_e=ue.length;ae<_e;ae++){let ye=i.get(ue[ae]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[ae])}i.remove(R)}let Z=0;function Q(){Z=0}function se(){return Z}function fe(R){Z=R}function he(){let R=Z;return R>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,R}function ee(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let q=i.get(R);if(R.isVideoTexture&&Ot(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{zt(q,R,M);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ve(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){zt(q,R,M);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ae(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){zt(q,R,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Se(R,M){let q=i.get(R);if(R.version>0&&q.__version!==R.version){dn(q,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let We={[Yc]:n.REPEAT,[ds]:n.CLAMP_TO_EDGE,[$c]:n.MIRRORED_REPEAT},ot={[On]:n.NEAREST,[v0]:n.NEAREST_MIPMAP_NEAREST,[ul]:n.NEAREST_MIPMAP_LINEAR,[zn]:n.LINEAR,[Su]:n.LINEAR_MIPMAP_NEAREST,[Os]:n.LINEAR_MIPMAP_LINEAR},Ve={[S0]:n.NEVER,[Hd]:n.ALWAYS,[M0]:n.LESS,[Gd]:n.LEQUAL,[w0]:n.EQUAL,[Vd]:n.GEQUAL,[T0]:n.GREATER,[E0]:n.NOTEQUAL};function ft(R,M){if(M.type===Ji&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===zn||M.magFilter===Su||M.magFilter===ul||M.magFilter===Os||M.minFilter===zn||M.minFilter===Su||M.minFilter===ul||M.minFilter===Os)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,We[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,We[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,We[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ot[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ot[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ve[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===On||M.minFilter!==ul&&M.minFilter!==Os||M.type===Ji&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ct(R,M){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),B(M));let ue=M.source,ae=d.get(ue);ae===void 0&&(ae={},d.set(ue,ae));let _e=ee(M);if(_e!==R.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[_e].usedTimes++;let ye=ae[R.__cacheKey];ye!==void 0&&(ae[R.__cacheKey].usedTimes--,ye.usedTimes===0&&G(M)),R.__cacheKey=_e,R.__webglTexture=ae[_e].texture}return q}function st(R,M,q){return Math.floor(Math.floor(R/q)/M)}function Zt(R,M,q,ue){let _e=R.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{_e.sort((U,re)=>U.start-re.start);let ye=0;for(let U=1;U<_e.length;U++){let re=_e[ye],ne=_e[U],we=re.start+re.count,ge=st(ne.start,M.width,4),be=st(re.start,M.width,4);ne.start<=we+1&&ge===be&&st(ne.start+ne.count-1,M.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let U=0,re=_e.length;U<re;U++){let ne=_e[U],we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%M.width,He=Math.floor(we/M.width),Je=ge,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,He),t.texSubImage2D(n.TEXTURE_2D,0,be,He,Je,ce,q,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function zt(R,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let ae=ct(R,M),_e=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(_e);if(_e.version!==ye.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=yt.getPrimaries(yt.workingColorSpace),Oe=M.colorSpace===ks?null:yt.getPrimaries(M.colorSpace),je=M.colorSpace===ks||ce===Oe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=b(M.image,!1,s.maxTextureSize);ie=ze(M,ie);let pe=r.convert(M.format,M.colorSpace),U=r.convert(M.type),re=C(M.internalFormat,pe,U,M.normalized,M.colorSpace,M.isVideoTexture);ft(ue,M);let ne,we=M.mipmaps,ge=M.isVideoTexture!==!0,be=ye.__version===void 0||ae===!0,He=_e.dataReady,Je=A(M,ie);if(M.isDepthTexture)re=v(M.format===Bs,M.type),be&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,U,null));else if(M.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,U,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,U,ne.data);M.generateMipmaps=!1}else ge?(be&&t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height),He&&Zt(M,ie,pe,U)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,U,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,we[0].width,we[0].height,ie.depth);for(let ce=0,Oe=we.length;ce<Oe;ce++)if(ne=we[ce],M.format!==Qi)if(pe!==null)if(ge){if(He)if(M.layerUpdates.size>0){let je=Qd(ne.width,ne.height,M.format,M.type);for(let Ce of M.layerUpdates){let lt=ne.data.subarray(Ce*je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?He&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,U,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,pe,U,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],M.format!==Qi?pe!==null?ge?He&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,U,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,U,ne.data)}else if(M.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,ie.width,ie.height,ie.depth),He)if(M.layerUpdates.size>0){let ce=Qd(ie.width,ie.height,M.format,M.type);for(let Oe of M.layerUpdates){let je=ie.data.subarray(Oe*ce/ie.data.BYTES_PER_ELEMENT,(Oe+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Oe,ie.width,ie.height,1,pe,U,je)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,U,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,U,ie.data);else if(M.isData3DTexture)ge?(be&&t.texStorage3D(n.TEXTURE_3D,Je,re,ie.width,ie.height,ie.depth),He&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,U,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,pe,U,ie.data);else if(M.isFramebufferTexture){if(be)if(ge)t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height);else{let ce=ie.width,Oe=ie.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,re,ce,Oe,0,pe,U,null),ce>>=1,Oe>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),f.add(M),ce.onpaint=Oe=>{let je=Oe.changedElements;for(let Ce of f)je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let je=n.RGBA,Ce=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Ce,lt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=Ye(we[0]);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,U,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,U,ne);M.generateMipmaps=!1}else if(ge){if(be){let ce=Ye(ie);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}He&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,U,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,U,ie);E(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=_e.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function dn(R,M,q){if(M.image.length!==6)return;let ue=ct(R,M),ae=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let _e=i.get(ae);if(ae.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=yt.getPrimaries(yt.workingColorSpace),te=M.colorSpace===ks?null:yt.getPrimaries(M.colorSpace),ie=M.colorSpace===ks||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,U=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!U?re[Ce]=b(M.image[Ce],!0,s.maxCubemapSize):re[Ce]=U?M.image[Ce].image:M.image[Ce],re[Ce]=ze(M,re[Ce]);let ne=re[0],we=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=C(M.internalFormat,we,ge,M.normalized,M.colorSpace),He=M.isVideoTexture!==!0,Je=_e.__version===void 0||ue===!0,ce=ae.dataReady,Oe=A(M,ne);ft(n.TEXTURE_CUBE_MAP,M);let je;if(M.isDepthTexture){if(be=v(M.format===Bs,M.type),Je)if(He)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,0,we,ge,null)}else if(pe){He&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){je=re[Ce].mipmaps;for(let lt=0;lt<je.length;lt++){let Vt=je[lt];M.format!==Qi?we!==null?He?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Vt.width,Vt.height,we,Vt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,be,Vt.width,Vt.height,0,Vt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Vt.width,Vt.height,we,ge,Vt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,be,Vt.width,Vt.height,0,we,ge,Vt.data)}}}else{if(je=M.mipmaps,He&&Je){je.length>0&&Oe++;let Ce=Ye(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(U){He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,we,ge,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,re[Ce].width,re[Ce].height,0,we,ge,re[Ce].data);for(let lt=0;lt<je.length;lt++){let Xn=je[lt].image[Ce].image;He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Xn.width,Xn.height,we,ge,Xn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,be,Xn.width,Xn.height,0,we,ge,Xn.data)}}else{He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ge,re[Ce]);for(let lt=0;lt<je.length;lt++){let Vt=je[lt];He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,we,ge,Vt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,be,we,ge,Vt.image[Ce])}}}E(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=ae.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ft(R,M,q,ue,ae,_e){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ie=C(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(M),U=i.get(q);if(U.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>_e),ne=Math.max(1,M.height>>_e);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,ie,re,ne,M.depth,0,ye,te,null):t.texImage2D(ae,_e,ie,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,ae,U.__webglTexture,0,at(M)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,ae,U.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function In(R,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,_e=v(M.stencilBuffer,ae),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),_e,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let ae=0;ae<ue.length;ae++){let _e=ue[ae],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),ie=C(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),ie,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(R,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(M.depthTexture);ae.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!ae.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):me(M.depthTexture,0);let ye=ae.__webglTexture,te=at(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===Bs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Ns)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else if(M.depthTexture.format===Bs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Mn(R){let M=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let ae=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),M.__depthDisposeCallback=ae}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)bt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?bt(M.__webglFramebuffer[0],R,0):bt(M.__webglFramebuffer,R,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),In(M.__webglDepthbuffer[ue],R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),In(M.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function nn(R,M,q){let ue=i.get(R);M!==void 0&&Ft(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Mn(R)}function pn(R){let M=R.texture,q=i.get(R),ue=i.get(M);R.addEventListener("dispose",k),B(R);let ae=R.textures,_e=R.isWebGLCubeRenderTarget===!0,ye=ae.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,ie=ae.length;te<ie;te++){let pe=i.get(ae[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let ie=ae[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(ie.format,ie.colorSpace),U=r.convert(ie.type),re=C(ie.internalFormat,pe,U,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=at(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),In(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ft(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ft(q.__webglFramebuffer[te][ie],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Ft(q.__webglFramebuffer[te],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);E(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=ae.length;te<ie;te++){let pe=ae[te],U=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,U.__webglTexture),ft(re,pe),Ft(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,re,0),E(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ft(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ft(q.__webglFramebuffer[ie],R,M,n.COLOR_ATTACHMENT0,te,ie);else Ft(q.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,te,0);E(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Mn(R)}function O(R){let M=R.textures;for(let q=0,ue=M.length;q<ue;q++){let ae=M[q];if(E(ae)&&ae.mipmapsAutoUpdate===!0){let _e=P(R),ye=i.get(ae).__webglTexture;t.bindTexture(_e,ye),S(_e),t.unbindTexture()}}}let Re=[];function Ze(R){if(R.samples>0){if(Me(R)===!1){let M=R.textures,q=R.width,ue=R.height,ae=n.COLOR_BUFFER_BIT,_e=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let U=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,U,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,ae,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let U=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,U,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function at(R){return Math.min(s.maxSamples,R.samples)}function Me(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ot(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function ze(R,M){let q=R.colorSpace,ue=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==Xa&&q!==ks&&(yt.getTransfer(q)===Pt?(ue!==Qi||ae!==Ti)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",q)),M}function Ye(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ae,this.setTextureCube=Se,this.rebindTextures=nn,this.setupRenderTarget=pn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Mn,this.setupFrameBufferTexture=Ft,this.useMultisampledRTT=Me,this.dispose=H}function AA(n,e){function t(i,s=ks){let r,o=yt.getTransfer(s);if(i===Ti)return n.UNSIGNED_BYTE;if(i===wu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Tu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Fd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ud)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Dd)return n.BYTE;if(i===Nd)return n.SHORT;if(i===ia)return n.UNSIGNED_SHORT;if(i===Mu)return n.INT;if(i===Ki)return n.UNSIGNED_INT;if(i===Ji)return n.FLOAT;if(i===ji)return n.HALF_FLOAT;if(i===Od)return n.ALPHA;if(i===Bd)return n.RGB;if(i===Qi)return n.RGBA;if(i===Ns)return n.DEPTH_COMPONENT;if(i===Bs)return n.DEPTH_STENCIL;if(i===kd)return n.RED;if(i===Eu)return n.RED_INTEGER;if(i===yr)return n.RG;if(i===Au)return n.RG_INTEGER;if(i===Cu)return n.RGBA_INTEGER;if(i===hl||i===fl||i===dl||i===pl)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===hl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===hl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ru||i===Pu||i===Iu||i===Lu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ru)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Pu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Iu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Lu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Du||i===Nu||i===Fu||i===Uu||i===Ou||i===ml||i===Bu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Du||i===Nu)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Fu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Uu)return r.COMPRESSED_R11_EAC;if(i===Ou)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ml)return r.COMPRESSED_RG11_EAC;if(i===Bu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===ku||i===zu||i===Gu||i===Vu||i===Hu||i===Wu||i===qu||i===Xu||i===Yu||i===$u||i===Zu||i===Ku||i===Ju||i===ju)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===ku)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===zu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Gu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Vu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Hu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Wu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===qu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Xu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Yu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===$u)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Zu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ku)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ju)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===ju)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Qu||i===eh||i===th)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Qu)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===eh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===th)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===nh||i===ih||i===gl||i===sh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===nh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===ih)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===gl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===sh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===$r?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var CA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,RA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,lp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new sl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Mi({vertexShader:CA,fragmentShader:RA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ui(new rl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},cp=class extends Zi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,y=typeof XRWebGLBinding<"u",_=new lp,g={},b=t.getContextAttributes(),E=null,S=null,P=[],C=[],v=new it,A=null,B=null,N=new Qn;N.viewport=new tn;let L=new Qn;L.viewport=new tn;let k=[N,L],V=new yu,F=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=P[ee];return me===void 0&&(me=new $o,P[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=P[ee];return me===void 0&&(me=new $o,P[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=P[ee];return me===void 0&&(me=new $o,P[ee]=me),me.getHandSpace()};function Y(ee){let me=C.indexOf(ee.inputSource);if(me===-1)return;let ve=P[me];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",oe);for(let ee=0;ee<P.length;ee++){let me=C[ee];me!==null&&(C[ee]=null,P[ee].disconnect(me))}F=null,H=null,_.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(E),d=null,h=null,f=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(A),e.setSize(v.width,v.height,!1),B!==null){let ee=B.camera;ee.fov=B.fov,ee.zoom=B.zoom,ee.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&y&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",oe),b.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ae=null,Se=null;b.depth&&(Se=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=b.stencil?Bs:Ns,Ae=b.stencil?$r:Ki);let We={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(We),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new bi(h.textureWidth,h.textureHeight,{format:Qi,type:Ti,depthTexture:new Us(h.textureWidth,h.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ve={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new bi(d.framebufferWidth,d.framebufferHeight,{format:Qi,type:Ti,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function oe(ee){for(let me=0;me<ee.removed.length;me++){let ve=ee.removed[me],Ae=C.indexOf(ve);Ae>=0&&(C[Ae]=null,P[Ae].disconnect(ve))}for(let me=0;me<ee.added.length;me++){let ve=ee.added[me],Ae=C.indexOf(ve);if(Ae===-1){for(let We=0;We<P.length;We++)if(We>=C.length){C.push(ve),Ae=We;break}else if(C[We]===null){C[We]=ve,Ae=We;break}if(Ae===-1)break}let Se=P[Ae];Se&&Se.connect(ve)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ve=ee.far;_.texture!==null&&(_.depthNear>0&&(me=_.depthNear),_.depthFar>0&&(ve=_.depthFar)),V.near=L.near=N.near=me,V.far=L.far=N.far=ve,(F!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),F=V.near,H=V.far),V.layers.mask=ee.layers.mask|6,N.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let Ae=ee.parent,Se=V.cameras;Z(V,Ae);for(let We=0;We<Se.length;We++)Z(Se[We],Ae);V.projectionMatrix.copy(N.projectionMatrix),V.projectionMatrixInverse.copy(N.projectionMatrixInverse),B===null&&ee.isPerspectiveCamera&&(B={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,V,Ae)};function Q(ee,me,ve){ve===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Xo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(V)},this.getCameraTexture=function(ee){return g[ee]};let se=null;function fe(ee,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ve=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Ae=!1;ve.length!==V.cameras.length&&(V.cameras.length=0,Ae=!0);for(let Ve=0;Ve<ve.length;Ve++){let ft=ve[Ve],ct=null;if(d!==null)ct=d.getViewport(ft);else{let Zt=f.getViewSubImage(h,ft);ct=Zt.viewport,Ve===0&&(e.setRenderTargetTextures(S,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(S))}let st=k[Ve];st===void 0&&(st=new Qn,st.layers.enable(Ve),st.viewport=new tn,k[Ve]=st),st.matrix.fromArray(ft.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(ft.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(ct.x,ct.y,ct.width,ct.height),Ve===0&&(V.matrix.copy(st.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ae===!0&&V.cameras.push(st)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){f=i.getBinding();let Ve=f.getDepthInformation(ve[0]);Ve&&Ve.isValid&&Ve.texture&&_.init(Ve,s.renderState)}if(Se&&Se.includes("camera-access")&&y){e.state.unbindTexture(),f=i.getBinding();for(let Ve=0;Ve<ve.length;Ve++){let ft=ve[Ve].camera;if(ft){let ct=g[ft];ct||(ct=new sl,g[ft]=ct);let st=f.getCameraImage(ft);ct.sourceTexture=st}}}}for(let ve=0;ve<P.length;ve++){let Ae=C[ve],Se=P[ve];Ae!==null&&Se!==void 0&&Se.update(Ae,me,c||o)}se&&se(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new rv;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},PA=new en,mv=new et;mv.set(-1,0,0,0,1,0,0,0,1);function IA(n,e){function t(_,g){_.matrixAutoUpdate===!0&&_.updateMatrix(),g.value.copy(_.matrix)}function i(_,g){g.color.getRGB(_.fogColor.value,Kd(n)),g.isFog?(_.fogNear.value=g.near,_.fogFar.value=g.far):g.isFogExp2&&(_.fogDensity.value=g.density)}function s(_,g,b,E,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(_,g):g.isMeshLambertMaterial?(r(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(_,g),f(_,g)):g.isMeshPhongMaterial?(r(_,g),u(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(_,g),h(_,g),g.isMeshPhysicalMaterial&&d(_,g,S)):g.isMeshMatcapMaterial?(r(_,g),p(_,g)):g.isMeshDepthMaterial?r(_,g):g.isMeshDistanceMaterial?(r(_,g),y(_,g)):g.isMeshNormalMaterial?r(_,g):g.isLineBasicMaterial?(o(_,g),g.isLineDashedMaterial&&a(_,g)):g.isPointsMaterial?l(_,g,b,E):g.isSpriteMaterial?c(_,g):g.isShadowMaterial?(_.color.value.copy(g.color),_.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(_,g){_.opacity.value=g.opacity,g.color&&_.diffuse.value.copy(g.color),g.emissive&&_.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.bumpMap&&(_.bumpMap.value=g.bumpMap,t(g.bumpMap,_.bumpMapTransform),_.bumpScale.value=g.bumpScale,g.side===ti&&(_.bumpScale.value*=-1)),g.normalMap&&(_.normalMap.value=g.normalMap,t(g.normalMap,_.normalMapTransform),_.normalScale.value.copy(g.normalScale),g.side===ti&&_.normalScale.value.negate()),g.displacementMap&&(_.displacementMap.value=g.displacementMap,t(g.displacementMap,_.displacementMapTransform),_.displacementScale.value=g.displacementScale,_.displacementBias.value=g.displacementBias),g.emissiveMap&&(_.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,_.emissiveMapTransform)),g.specularMap&&(_.specularMap.value=g.specularMap,t(g.specularMap,_.specularMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest);let b=e.get(g),E=b.envMap,S=b.envMapRotation;E&&(_.envMap.value=E,_.envMapRotation.value.setFromMatrix4(PA.makeRotationFromEuler(S)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(mv),_.reflectivity.value=g.reflectivity,_.ior.value=g.ior,_.refractionRatio.value=g.refractionRatio),g.lightMap&&(_.lightMap.value=g.lightMap,_.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,_.lightMapTransform)),g.aoMap&&(_.aoMap.value=g.aoMap,_.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,_.aoMapTransform))}function o(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform))}function a(_,g){_.dashSize.value=g.dashSize,_.totalSize.value=g.dashSize+g.gapSize,_.scale.value=g.scale}function l(_,g,b,E){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.size.value=g.size*b,_.scale.value=E*.5,g.map&&(_.map.value=g.map,t(g.map,_.uvTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function c(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.rotation.value=g.rotation,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function u(_,g){_.specular.value.copy(g.specular),_.shininess.value=Math.max(g.shininess,1e-4)}function f(_,g){g.gradientMap&&(_.gradientMap.value=g.gradientMap)}function h(_,g){_.metalness.value=g.metalness,g.metalnessMap&&(_.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,_.metalnessMapTransform)),_.roughness.value=g.roughness,g.roughnessMap&&(_.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,_.roughnessMapTransform)),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)}function d(_,g,b){_.ior.value=g.ior,g.diffuseRoughness>0&&(_.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),g.sheen>0&&(_.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),_.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(_.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,_.sheenColorMapTransform)),g.sheenRoughnessMap&&(_.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,_.sheenRoughnessMapTransform))),g.clearcoat>0&&(_.clearcoat.value=g.clearcoat,_.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(_.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,_.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(_.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ti&&_.clearcoatNormalScale.value.negate())),g.dispersion>0&&(_.dispersion.value=g.dispersion),g.retroreflectivity>0&&(_.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(_.iridescence.value=g.iridescence,_.iridescenceIOR.value=g.iridescenceIOR,_.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(_.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,_.iridescenceMapTransform)),g.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),g.transmission>0&&(_.transmission.value=g.transmission,_.transmissionSamplerMap.value=b.texture,_.transmissionSamplerSize.value.set(b.width,b.height),g.transmissionMap&&(_.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,_.transmissionMapTransform)),_.thickness.value=g.thickness,g.thicknessMap&&(_.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=g.attenuationDistance,_.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(_.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(_.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=g.specularIntensity,_.specularColor.value.copy(g.specularColor),g.specularColorMap&&(_.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,_.specularColorMapTransform)),g.specularIntensityMap&&(_.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,_.specularIntensityMapTransform))}function p(_,g){g.matcap&&(_.matcap.value=g.matcap)}function y(_,g){let b=e.get(g).light;_.referencePosition.value.setFromMatrixPosition(b.matrixWorld),_.nearDistance.value=b.shadow.camera.near,_.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function LA(n,e,t,i){let s={},r={};function o(b,E){let S=E.program;i.uniformBlockBinding(b,S,s[b.id])}function a(b,E){let S=s[b.id];S===void 0&&(p(b),S=l(b),s[b.id]=S,b.addEventListener("dispose",_));let P=E.program;i.updateUBOMapping(b,P);let C=e.render.frame;r[b.id]!==C&&(c(b),r[b.id]=C)}function l(b){let E=n.createBuffer(),S=b.__size,P=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,S,P),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(b){let E=s[b.id],S=b.uniforms,P=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let C=0,v=S.length;C<v;C++){let A=S[C];if(Array.isArray(A))for(let B=0,N=A.length;B<N;B++)u(A[B],C,B,P);else u(A,C,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(b,E,S,P){if(h(b,E,S,P)===!0){let C=b.__offset,v=b.value;if(Array.isArray(v)){let A=0;for(let B=0;B<v.length;B++){let N=v[B],L=y(N,!0);f(N,b.__data,A),A+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(v,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,b.__data)}}function f(b,E,S){typeof b=="number"||typeof b=="boolean"?E[S]=b:b.isMatrix3?(E[S]=b.elements[0],E[S+1]=b.elements[1],E[S+2]=b.elements[2],E[S+3]=0,E[S+4]=b.elements[3],E[S+5]=b.elements[4],E[S+6]=b.elements[5],E[S+7]=0,E[S+8]=b.elements[6],E[S+9]=b.elements[7],E[S+10]=b.elements[8],E[S+11]=0):ArrayBuffer.isView(b)?E.set(b.subarray(0,E.length-S),S):b.toArray(E,S)}function h(b,E,S,P){let C=b.value,v=E+"_"+S;if(Array.isArray(C)){P[v]===void 0&&(P[v]=[]);let A=P[v],B=!1;for(let N=0;N<C.length;N++)d(C[N],A,N)===!0&&(B=!0);return B}return d(C,P,v)}function d(b,E,S){if(E[S]===void 0)return typeof b=="number"||typeof b=="boolean"?E[S]=b:ArrayBuffer.isView(b)?E[S]=b.slice():E[S]=b.clone(),!0;{let P=E[S];if(typeof b=="number"||typeof b=="boolean"){if(P!==b)return E[S]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(P.equals(b)===!1)return P.copy(b),!0}}return!1}function p(b){let E=b.uniforms,S=0,P=16;for(let v=0,A=E.length;v<A;v++){let B=Array.isArray(E[v])?E[v]:[E[v]];for(let N=0,L=B.length;N<L;N++){let k=B[N],V=Array.isArray(k.value)?k.value:[k.value],F=Array.isArray(E[v])||Array.isArray(k.value),H=S;for(let G=0,oe=V.length;G<oe;G++){let Z=V[G],Q=y(Z,F),se=S%P,fe=se%Q.boundary,he=se+fe;S+=fe,he!==0&&P-he<Q.storage&&(S+=P-he),G===0&&(H=S),S+=Q.storage}let Y=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Y((S-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let C=S%P;return C>0&&(S+=P-C),b.__size=S,b.__cache={},this}function y(b,E){let S={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(S.boundary=4,S.storage=4):b.isVector2?(S.boundary=8,S.storage=8):b.isVector3||b.isColor?(S.boundary=16,S.storage=12):b.isVector4?(S.boundary=16,S.storage=16):b.isMatrix3?(S.boundary=16,S.storage=48):b.isMatrix4?(S.boundary=16,S.storage=64):b.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(S.boundary=16,S.storage=b.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",b),E===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function _(b){let E=b.target;E.removeEventListener("dispose",_),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function g(){for(let b in s)n.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:g}}var DA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),_s=null;function NA(){return _s===null&&(_s=new Hr(DA,16,16,yr,ji),_s.name="DFG_LUT",_s.minFilter=zn,_s.magFilter=zn,_s.wrapS=ds,_s.wrapT=ds,_s.generateMipmaps=!1,_s.needsUpdate=!0),_s}var lh=class{constructor(e={}){let{canvas:t=C0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=Ti}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let y=d,_=new Set([Cu,Au,Eu]),g=new Set([Ti,Ki,ia,$r,wu,Tu]),b=new Uint32Array(4),E=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,C=null,v=[],A=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,k=null,V=null,F=null,H=null;this._outputColorSpace=vi;let Y=0,G=0,oe=null,Z=-1,Q=null,se=new tn,fe=new tn,he=null,ee=new xt(0),me=0,ve=t.width,Ae=t.height,Se=1,We=null,ot=null,Ve=new tn(0,0,ve,Ae),ft=new tn(0,0,ve,Ae),ct=!1,st=new Wr,Zt=new eu,zt=!1,dn=!1,Ft=new en,In=new K,bt=new tn,Mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nn=!1;function pn(){return oe===null?Se:1}let O=i;function Re(T,z){return t.getContext(T,z)}let Ze,at,Me,Ot,ze,Ye,R,M,q,ue,ae,_e,ye,te,ie,pe,U,re,ne,we,ge,be,He;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),O===null){let z="webgl2";if(O=Re(z,T),O===null)throw Re(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(T){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),nt("WebGLRenderer: "+T.message),T}function Je(){Ze=new qT(O),Ze.init(),ge=new AA(O,Ze),at=new NT(O,Ze,e,ge),Me=new TA(O,Ze),at.reversedDepthBuffer&&h&&Me.buffers.depth.setReversed(!0),V=O.createFramebuffer(),F=O.createFramebuffer(),H=O.createFramebuffer(),Ot=new $T(O),ze=new hA,Ye=new EA(O,Ze,Me,ze,at,ge,Ot),R=new WT(N),M=new KM(O),be=new LT(O,M),q=new XT(O,M,Ot,be),ue=new KT(O,q,M,be,Ot),re=new ZT(O,at,Ye),ie=new FT(ze),ae=new uA(N,R,Ze,at,be,ie),_e=new IA(N,ze),ye=new dA,te=new yA(Ze),U=new IT(N,R,Me,ue,p,l),pe=new wA(N,ue,at),He=new LA(O,Ot,at,Me),ne=new DT(O,Ze,Ot),we=new YT(O,Ze,Ot),Ot.programs=ae.programs,N.capabilities=at,N.extensions=Ze,N.properties=ze,N.renderLists=ye,N.shadowMap=pe,N.state=Me,N.info=Ot}y!==Ti&&(B=new jT(y,t.width,t.height,a,s,r));let ce=new cp(N,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let T=Ze.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ze.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(T){T!==void 0&&(Se=T,this.setSize(ve,Ae,!1))},this.getSize=function(T){return T.set(ve,Ae)},this.setSize=function(T,z,j=!0){if(ce.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Ae=z,t.width=Math.floor(T*Se),t.height=Math.floor(z*Se),j===!0&&(t.style.width=T+"px",t.style.height=z+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(ve*Se,Ae*Se).floor()},this.setDrawingBufferSize=function(T,z,j){ve=T,Ae=z,Se=j,t.width=Math.floor(T*j),t.height=Math.floor(z*j),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(y===Ti){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy(Ve)},this.setViewport=function(T,z,j,X){T.isVector4?Ve.set(T.x,T.y,T.z,T.w):Ve.set(T,z,j,X),Me.viewport(se.copy(Ve).multiplyScalar(pn()).round())},this.getScissor=function(T){return T.copy(ft)},this.setScissor=function(T,z,j,X){T.isVector4?ft.set(T.x,T.y,T.z,T.w):ft.set(T,z,j,X),Me.scissor(fe.copy(ft).multiplyScalar(pn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(T){Me.setScissorTest(ct=T)},this.setOpaqueSort=function(T){We=T},this.setTransparentSort=function(T){ot=T},this.getClearColor=function(T){return T.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,j=!0){let X=0;if(T){let $=!1;if(oe!==null){let Te=oe.texture.format;$=_.has(Te)}if($){let Te=oe.texture.type,Pe=g.has(Te),Ee=U.getClearColor(),Ie=U.getClearAlpha(),ke=Ee.r,tt=Ee.g,dt=Ee.b;Pe?(b[0]=ke,b[1]=tt,b[2]=dt,b[3]=Ie,O.clearBufferuiv(O.COLOR,0,b)):(E[0]=ke,E[1]=tt,E[2]=dt,E[3]=Ie,O.clearBufferiv(O.COLOR,0,E))}else X|=O.COLOR_BUFFER_BIT}z&&(X|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(X|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),X!==0&&O.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),U.dispose(),ye.dispose(),te.dispose(),Ye.dispose(),ze.dispose(),R.dispose(),ue.dispose(),q.dispose(),be.dispose(),He.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",wl),ce.removeEventListener("sessionend",ts),ys.stop()};function Oe(T){T.preventDefault(),qd("WebGLRenderer: Context Lost."),L=!0}function je(){qd("WebGLRenderer: Context Restored."),L=!1;let T=Ot.autoReset,z=pe.enabled,j=pe.autoUpdate,X=pe.needsUpdate,$=pe.type;Je(),Ot.autoReset=T,pe.enabled=z,pe.autoUpdate=j,pe.needsUpdate=X,pe.type=$}function Ce(T){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function lt(T){let z=T.target;z.removeEventListener("dispose",lt),Vt(z)}function Vt(T){Xn(T),ze.remove(T)}function Xn(T){let z=ze.get(T).programs;z!==void 0&&(z.forEach(function(j){ae.releaseProgram(j)}),T.isShaderMaterial&&ae.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,j,X,$,Te){z===null&&(z=Mn);let Pe=$.isMesh&&$.matrixWorld.determinantAffine()<0,Ee=da(T,z,j,X,$);Me.setMaterial(X,Pe);let Ie=j.index,ke=1;if(X.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ke=2}let tt=j.drawRange,dt=j.attributes.position,Be=tt.start*ke,pt=(tt.start+tt.count)*ke;Te!==null&&(Be=Math.max(Be,Te.start*ke),pt=Math.min(pt,(Te.start+Te.count)*ke)),Ie!==null?(Be=Math.max(Be,0),pt=Math.min(pt,Ie.count)):dt!=null&&(Be=Math.max(Be,0),pt=Math.min(pt,dt.count));let jt=pt-Be;if(jt<0||jt===1/0)return;be.setup($,X,Ee,j,Ie);let It,Lt=ne;if(Ie!==null&&(It=M.get(Ie),Lt=we,Lt.setIndex(It)),$.isMesh)X.wireframe===!0?(Me.setLineWidth(X.wireframeLinewidth*pn()),Lt.setMode(O.LINES)):Lt.setMode(O.TRIANGLES);else if($.isLine){let wn=X.linewidth;wn===void 0&&(wn=1),Me.setLineWidth(wn*pn()),$.isLineSegments?Lt.setMode(O.LINES):$.isLineLoop?Lt.setMode(O.LINE_LOOP):Lt.setMode(O.LINE_STRIP)}else $.isPoints?Lt.setMode(O.POINTS):$.isSprite&&Lt.setMode(O.TRIANGLES);if($.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Lt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let wn=$._multiDrawStarts,Fe=$._multiDrawCounts,mn=$._multiDrawCount,_t=Ie?M.get(Ie).bytesPerElement:1,bs=ze.get(X).currentProgram.getUniforms();for(let gn=0;gn<mn;gn++)bs.setValue(O,"_gl_DrawID",gn),Lt.render(wn[gn]/_t,Fe[gn])}else if($.isInstancedMesh)Lt.renderInstances(Be,jt,$.count);else if(j.isInstancedBufferGeometry){let wn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,wn);Lt.renderInstances(Be,jt,Fe)}else Lt.render(Be,jt)};function ua(T,z,j,X){k!==null&&T.isNodeMaterial&&k.setObject(X,T),zt===!0&&ie.setState(T,j,!1),T.transparent===!0&&T.side===Oi&&T.forceSinglePass===!1?(T.side=ti,T.needsUpdate=!0,ns(T,z,X),T.side=vr,T.needsUpdate=!0,ns(T,z,X),T.side=Oi):ns(T,z,X)}this.compile=function(T,z,j=null){j===null&&(j=T),k!==null&&k.renderStart(T,z,j),C=te.get(j),C.init(z),A.push(C),j.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),T!==j&&T.traverseVisible(function($){$.isLight&&$.layers.test(z.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),C.setupLights(),k!==null&&k.updateLights(C.state.lightsArray),dn=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,dn),zt===!0&&ie.setGlobalState(this.clippingPlanes,z),k!==null&&pe.render(C.state.shadowsArray,j,z);let X=new Set;return T.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Te=$.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ee=Te[Pe];ua(Ee,j,z,$),X.add(Ee)}else ua(Te,j,z,$),X.add(Te)}),C=A.pop(),k!==null&&k.renderEnd(),X},this.compileAsync=function(T,z,j=null){let X=this.compile(T,z,j);return new Promise($=>{function Te(){if(X.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&X.delete(Pe)}),X.size===0){$(T);return}setTimeout(Te,10)}Ze.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Jr=null;function Ch(T){Jr&&Jr(T)}function wl(){ys.stop()}function ts(){ys.start()}let ys=new rv;ys.setAnimationLoop(Ch),typeof self<"u"&&ys.setContext(self),this.setAnimationLoop=function(T){Jr=T,ce.setAnimationLoop(T),T===null?ys.stop():ys.start()},ce.addEventListener("sessionstart",wl),ce.addEventListener("sessionend",ts),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;k!==null&&k.renderStart(T,z);let j=ce.enabled===!0&&ce.isPresenting===!0,X=B!==null&&(oe===null||j)&&B.begin(N,oe);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(N,T,z,oe),C=te.get(T,A.length),C.init(z),C.state.textureUnits=Ye.getTextureUnits(),A.push(C),Ft.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Zt.setFromArrayCamera(z):st.setFromProjectionMatrix(Ft,Fi,z.reversedDepth),dn=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,dn),P=ye.get(T,v.length),P.init(),v.push(P),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&xs(Pe,z,-1/0,N.sortObjects)}xs(T,z,0,N.sortObjects),P.finish(),k!==null&&k.updateLights(C.state.lightsArray),N.sortObjects===!0&&P.sort(We,ot),nn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,nn&&U.addToRenderList(P,T),this.info.autoReset===!0&&this.info.reset(),zt===!0&&ie.beginShadows();let $=C.state.shadowsArray;if(pe.render($,T,z),zt===!0&&ie.endShadows(),(X&&B.hasRenderPass())===!1){let Pe=P.opaque,Ee=P.transmissive;if(C.setupLights(),z.isArrayCamera){let Ie=z.cameras;if(Ee.length>0)for(let ke=0,tt=Ie.length;ke<tt;ke++){let dt=Ie[ke];Bi(Pe,Ee,T,dt)}nn&&U.render(T);for(let ke=0,tt=Ie.length;ke<tt;ke++){let dt=Ie[ke];ha(P,T,dt,dt.viewport)}}else Ee.length>0&&Bi(Pe,Ee,T,z),nn&&U.render(T),ha(P,T,z)}oe!==null&&G===0&&(Ye.updateMultisampleRenderTarget(oe),Ye.updateRenderTargetMipmap(oe)),X&&B.end(N),T.isScene===!0&&T.onAfterRender(N,T,z),be.resetDefaultState(),Z=-1,Q=null,A.pop(),A.length>0?(C=A[A.length-1],Ye.setTextureUnits(C.state.textureUnits),zt===!0&&ie.setGlobalState(N.clippingPlanes,C.state.camera)):C=null,v.pop(),v.length>0?P=v[v.length-1]:P=null,k!==null&&k.renderEnd()};function xs(T,z,j,X){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)C.pushLight(T),T.castShadow&&C.pushShadow(T);else if(T.isSprite){let Pe=z.isArrayCamera?Zt:st;if(!T.frustumCulled||T.intersectsFrustum(Pe)){X&&bt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ft);let Ee=ue.update(T),Ie=T.material;Ie.visible&&P.push(T,Ee,Ie,j,bt.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=z.isArrayCamera?Zt:st;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Ee=ue.update(T),Ie=T.material;if(X&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),bt.copy(T.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),bt.copy(Ee.boundingSphere.center)),bt.applyMatrix4(T.matrixWorld).applyMatrix4(Ft)),Array.isArray(Ie)){let ke=Ee.groups;for(let tt=0,dt=ke.length;tt<dt;tt++){let Be=ke[tt],pt=Ie[Be.materialIndex];pt&&pt.visible&&P.push(T,Ee,pt,j,bt.z,Be,z)}}else Ie.visible&&P.push(T,Ee,Ie,j,bt.z,null,z)}}}let Te=T.children;for(let Pe=0,Ee=Te.length;Pe<Ee;Pe++)xs(Te[Pe],z,j,X)}function ha(T,z,j,X){let{opaque:$,transmissive:Te,transparent:Pe}=T;C.setupLightsView(j),zt===!0&&ie.setGlobalState(N.clippingPlanes,j),X&&Me.viewport(se.copy(X)),$.length>0&&sn($,z,j),Te.length>0&&sn(Te,z,j),Pe.length>0&&sn(Pe,z,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Bi(T,z,j,X){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[X.id]===void 0){let Be=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[X.id]=new bi(1,1,{generateMipmaps:!0,type:Be?ji:Ti,minFilter:Os,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:yt.workingColorSpace})}let Te=C.state.transmissionRenderTarget[X.id],Pe=X.viewport||se;Te.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Ee=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ke=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),nn&&U.render(j);let tt=N.toneMapping;N.toneMapping=gs;let dt=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),C.setupLightsView(X),zt===!0&&ie.setGlobalState(N.clippingPlanes,X),sn(T,j,X),Ye.updateMultisampleRenderTarget(Te),Ye.updateRenderTargetMipmap(Te),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let pt=0,jt=z.length;pt<jt;pt++){let It=z[pt],{object:Lt,geometry:wn,material:Fe,group:mn}=It;if(Fe.side===Oi&&Lt.layers.test(X.layers)){let _t=Fe.side;Fe.side=ti,Fe.needsUpdate=!0,cn(Lt,j,X,wn,Fe,mn),Fe.side=_t,Fe.needsUpdate=!0,Be=!0}}Be===!0&&(Ye.updateMultisampleRenderTarget(Te),Ye.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ee,Ie,ke),N.setClearColor(ee,me),dt!==void 0&&(X.viewport=dt),N.toneMapping=tt}function sn(T,z,j){let X=z.isScene===!0?z.overrideMaterial:null;for(let $=0,Te=T.length;$<Te;$++){let Pe=T[$],{object:Ee,geometry:Ie,group:ke}=Pe,tt=Pe.material;tt.allowOverride===!0&&X!==null&&(tt=X),Ee.layers.test(j.layers)&&cn(Ee,z,j,Ie,tt,ke)}}function cn(T,z,j,X,$,Te){k!==null&&$.isNodeMaterial&&k.setObject(T,$),T.onBeforeRender(N,z,j,X,$,Te),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),$.onBeforeRender(N,z,j,X,T,Te),$.transparent===!0&&$.side===Oi&&$.forceSinglePass===!1?($.side=ti,$.needsUpdate=!0,N.renderBufferDirect(j,z,X,$,T,Te),$.side=vr,$.needsUpdate=!0,N.renderBufferDirect(j,z,X,$,T,Te),$.side=Oi):N.renderBufferDirect(j,z,X,$,T,Te),T.onAfterRender(N,z,j,X,$,Te)}function un(T){let z=0;for(let j of T)j.texture!==null&&z++;return z}function ns(T,z,j){z.isScene!==!0&&(z=Mn);let X=ze.get(T),$=C.state.lights,Te=C.state.shadowsArray,Pe=$.state.version,Ee=ae.getParameters(T,$.state,Te,z,j,C.state.lightProbeGridArray),Ie=ae.getProgramCacheKey(Ee),ke=X.programs;X.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,X.fog=z.fog;let tt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;X.envMap=R.get(T.envMap||X.environment,tt),X.envMapRotation=X.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,ke===void 0&&(T.addEventListener("dispose",lt),ke=new Map,X.programs=ke,X.programVariants=new Map);let dt=ke.get(Ie);if(dt!==void 0){if(X.currentProgram===dt&&X.lightsStateVersion===Pe)return fa(T,Ee),dt}else Ee.uniforms=ae.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,j,Ee),T.onBeforeCompile(Ee,N),dt=ae.acquireProgram(Ee,Ie),ke.set(Ie,dt),X.uniforms=Ee.uniforms;let Be=X.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Be.clippingPlanes=ie.uniform),fa(T,Ee),X.needsLights=Vs(T),X.lightsStateVersion=Pe,X.needsLights&&(Be.ambientLightColor.value=$.state.ambient,Be.lightProbe.value=$.state.probe,Be.sunLights.value=$.state.sun,Be.sunLightShadows.value=$.state.sunShadow,Be.directionalLights.value=$.state.directional,Be.directionalLightShadows.value=$.state.directionalShadow,Be.spotLights.value=$.state.spot,Be.spotLightShadows.value=$.state.spotShadow,Be.rectAreaLights.value=$.state.rectArea,Be.ltc_1.value=$.state.rectAreaLTC1,Be.ltc_2.value=$.state.rectAreaLTC2,Be.pointLights.value=$.state.point,Be.pointLightShadows.value=$.state.pointShadow,Be.hemisphereLights.value=$.state.hemi,Be.sunShadowMatrix.value=$.state.sunShadowMatrix,Be.sunShadowCascade.value=$.state.sunShadowCascade,Be.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Be.spotLightMatrix.value=$.state.spotLightMatrix,Be.spotLightMap.value=$.state.spotLightMap,Be.pointShadowMatrix.value=$.state.pointShadowMatrix),X.numLightProbeGrids=un(C.state.lightProbeGridArray),X.currentProgram=dt,X.uniformsList=null,dt}function ci(T,z,j,X,$){let Te=ze.get(T),Pe=Te.currentProgram.id+","+X+","+$,Ee=Te.programVariants.get(Pe);return Ee===void 0?(Ee=ns(T,z,j),Te.programVariants.set(Pe,Ee)):(Te.currentProgram=Ee,Te.uniformsList=null,Te.outputColorSpace=X,Te.toneMapping=$),Ee}function Gs(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=ra.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function fa(T,z){let j=ze.get(T);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function da(T,z,j,X,$){z.isScene!==!0&&(z=Mn),Ye.resetTextureUnits();let Te=z.fog,Pe=X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial?z.environment:null,Ee=oe===null?N.outputColorSpace:oe.isXRRenderTarget===!0?oe.texture.colorSpace:yt.workingColorSpace,Ie=X.isMeshStandardMaterial||X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,ke=R.get(X.envMap||Pe,Ie),tt=X.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,dt=!!j.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Be=!!j.morphAttributes.position,pt=!!j.morphAttributes.normal,jt=!!j.morphAttributes.color,It=gs;X.toneMapped&&(oe===null||oe.isXRRenderTarget===!0)&&(It=N.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,wn=Lt!==void 0?Lt.length:0,Fe=ze.get(X),mn=C.state.lights;if(zt===!0&&(dn===!0||T!==Q)){let Dt=T===Q&&X.id===Z;ie.setState(X,T,Dt)}let _t=!1,bs=!1;X.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==mn.state.version||$.isBatchedMesh&&Fe.batching===!1||!$.isBatchedMesh&&Fe.batching===!0||$.isBatchedMesh&&Fe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Fe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Fe.instancing===!1||!$.isInstancedMesh&&Fe.instancing===!0||$.isSkinnedMesh&&Fe.skinning===!1||!$.isSkinnedMesh&&Fe.skinning===!0||$.isInstancedMesh&&Fe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Fe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Fe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Fe.instancingMorph===!1&&$.morphTexture!==null||Fe.envMap!==ke||X.fog===!0&&Fe.fog!==Te||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ie.numPlanes||Fe.numIntersection!==ie.numIntersection)||Fe.vertexAlphas!==tt||Fe.vertexTangents!==dt||Fe.morphTargets!==Be||Fe.morphNormals!==pt||Fe.morphColors!==jt||Fe.morphTargetsCount!==wn||Fe.numLightProbeGrids!==un(C.state.lightProbeGridArray)?_t=!0:(Fe.outputColorSpace!==Ee||Fe.toneMapping!==It)&&(bs=!0):(_t=!0,Fe.__version=X.version);let gn=Fe.currentProgram;(_t===!0||bs===!0)&&(gn=bs===!0?ci(X,z,$,Ee,It):ns(X,z,$),k&&X.isNodeMaterial&&k.onUpdateProgram(X,gn,Fe));let eo=!1,is=!1,Ss=!1,ut=gn.getUniforms(),rn=Fe.uniforms;if(Me.useProgram(gn.program)&&(eo=!0,is=!0,Ss=!0),X.id!==Z&&(Z=X.id,is=!0),eo||Q!==T){Me.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ut.setValue(O,"projectionMatrix",T.projectionMatrix),ut.setValue(O,"viewMatrix",T.matrixWorldInverse);let _n=ut.map.cameraPosition;_n!==void 0&&_n.setValue(O,In.setFromMatrixPosition(T.matrixWorld)),at.logarithmicDepthBuffer&&ut.setValue(O,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&ut.setValue(O,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,is=!0,Ss=!0)}if(Fe.needsLights&&(mn.state.sunShadowMap.length>0&&ut.setValue(O,"sunShadowMap",mn.state.sunShadowMap,Ye),mn.state.directionalShadowMap.length>0&&ut.setValue(O,"directionalShadowMap",mn.state.directionalShadowMap,Ye),mn.state.spotShadowMap.length>0&&ut.setValue(O,"spotShadowMap",mn.state.spotShadowMap,Ye),mn.state.pointShadowMap.length>0&&ut.setValue(O,"pointShadowMap",mn.state.pointShadowMap,Ye)),$.isSkinnedMesh){ut.setOptional(O,$,"bindMatrix"),ut.setOptional(O,$,"bindMatrixInverse");let Dt=$.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ut.setValue(O,"boneTexture",Dt.boneTexture,Ye))}$.isBatchedMesh&&(ut.setOptional(O,$,"batchingTexture"),ut.setValue(O,"batchingTexture",$._matricesTexture,Ye),ut.setOptional(O,$,"batchingIdTexture"),ut.setValue(O,"batchingIdTexture",$._indirectTexture,Ye),ut.setOptional(O,$,"batchingColorTexture"),$._colorsTexture!==null&&ut.setValue(O,"batchingColorTexture",$._colorsTexture,Ye));let Yn=j.morphAttributes;if((Yn.position!==void 0||Yn.normal!==void 0||Yn.color!==void 0)&&re.update($,j,gn),(is||Fe.receiveShadow!==$.receiveShadow)&&(Fe.receiveShadow=$.receiveShadow,ut.setValue(O,"receiveShadow",$.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&z.environment!==null&&(rn.envMapIntensity.value=z.environmentIntensity),rn.dfgLUT!==void 0&&(rn.dfgLUT.value=NA()),is){if(ut.setValue(O,"toneMappingExposure",N.toneMappingExposure),Fe.needsLights&&jr(rn,Ss),Te&&X.fog===!0&&_e.refreshFogUniforms(rn,Te),_e.refreshMaterialUniforms(rn,X,Se,Ae,C.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Dt=S,_n=0;for(let Gn of C.state.lightProbeGridArray)Gn.texture!==null&&(Dt.textures[_n]=Gn.texture,Dt.min[_n]=Gn.boundingBox.min,Dt.max[_n]=Gn.boundingBox.max,Dt.resolution[_n]=Gn.resolution,_n++);for(let Gn in Dt)Dt[Gn].length=_n;rn.probesSH.value=Dt.textures,rn.probesMin.value=Dt.min,rn.probesMax.value=Dt.max,rn.probesResolution.value=Dt.resolution}ra.upload(O,Gs(Fe),rn,Ye)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(ra.upload(O,Gs(Fe),rn,Ye),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&ut.setValue(O,"center",$.center),ut.setValue(O,"modelViewMatrix",$.modelViewMatrix),ut.setValue(O,"normalMatrix",$.normalMatrix),ut.setValue(O,"modelMatrix",$.matrixWorld),X.uniformsGroups!==void 0){let Dt=X.uniformsGroups;for(let _n=0,Gn=Dt.length;_n<Gn;_n++){let Tl=Dt[_n];He.update(Tl,gn),He.bind(Tl,gn)}}return gn}function jr(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Vs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return oe},this.setRenderTargetTextures=function(T,z,j){let X=ze.get(T);X.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),ze.get(T.texture).__webglTexture=z,ze.get(T.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?void 0:j,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let j=ze.get(T);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,j=0){oe=T,Y=z,G=j;let X=null,$=!1,Te=!1;if(T){let Ee=ze.get(T);if(Ee.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(O.FRAMEBUFFER,Ee.__webglFramebuffer),se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest,Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),Z=-1;return}else if(Ee.__webglFramebuffer===void 0)Ye.setupRenderTarget(T);else if(Ee.__hasExternalTextures)Ye.rebindTextures(T,ze.get(T.texture).__webglTexture,ze.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let tt=T.depthTexture;if(Ee.__boundDepthTexture!==tt){if(tt!==null&&ze.has(tt)&&(T.width!==tt.image.width||T.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(T)}}let Ie=T.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ke=ze.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ke[z])?X=ke[z][j]:X=ke[z],$=!0):T.samples>0&&Ye.useMultisampledRTT(T)===!1?X=ze.get(T).__webglMultisampledFramebuffer:Array.isArray(ke)?X=ke[j]:X=ke,se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest}else se.copy(Ve).multiplyScalar(Se).floor(),fe.copy(ft).multiplyScalar(Se).floor(),he=ct;if(j!==0&&(X=V),Me.bindFramebuffer(O.FRAMEBUFFER,X)&&Me.drawBuffers(T,X),Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),$){let Ee=ze.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ee.__webglTexture,j)}else if(Te){let Ee=z;for(let Ie=0;Ie<T.textures.length;Ie++){let ke=ze.get(T.textures[Ie]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Ie,ke.__webglTexture,j,Ee)}}else if(T!==null&&j!==0){let Ee=ze.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ee.__webglTexture,j)}Z=-1};function Qr(T){let z=ze.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=at.textureFormatReadable(T.format),z.__typeReadable=at.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,j,X,$,Te,Pe,Ee=0){if(!(T&&T.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Me.bindFramebuffer(O.FRAMEBUFFER,Ie);try{let ke=T.textures[Ee],tt=ke.format,dt=ke.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=Qr(ke);if(Be.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-X&&j>=0&&j<=T.height-$&&O.readPixels(z,j,X,$,ge.convert(tt),ge.convert(dt),Te)}finally{let ke=oe!==null?ze.get(oe).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(T,z,j,X,$,Te,Pe,Ee=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(z>=0&&z<=T.width-X&&j>=0&&j<=T.height-$){Me.bindFramebuffer(O.FRAMEBUFFER,Ie);let ke=T.textures[Ee],tt=ke.format,dt=ke.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=Qr(ke);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.bufferData(O.PIXEL_PACK_BUFFER,Te.byteLength,O.STREAM_READ),O.readPixels(z,j,X,$,ge.convert(tt),ge.convert(dt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let jt=oe!==null?ze.get(oe).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,jt);let It=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await P0(O,It,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Te),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pt),O.deleteSync(It),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,j=0){let X=Math.pow(2,-j),$=Math.floor(T.image.width*X),Te=Math.floor(T.image.height*X),Pe=z!==null?z.x:0,Ee=z!==null?z.y:0;Ye.setTexture2D(T,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Pe,Ee,$,Te),Me.unbindTexture()},this.copyTextureToTexture=function(T,z,j=null,X=null,$=0,Te=0){let Pe,Ee,Ie,ke,tt,dt,Be,pt,jt,It=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(j!==null)Pe=j.max.x-j.min.x,Ee=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ke=j.min.x,tt=j.min.y,dt=j.isBox3?j.min.z:0;else{let ut=Math.pow(2,-$);Pe=Math.floor(It.width*ut),Ee=Math.floor(It.height*ut),T.isDataArrayTexture?Ie=It.depth:T.isData3DTexture?Ie=Math.floor(It.depth*ut):Ie=1,ke=0,tt=0,dt=0}X!==null?(Be=X.x,pt=X.y,jt=X.z):(Be=0,pt=0,jt=0);let Lt=ge.convert(z.format),wn=ge.convert(z.type),Fe;z.isData3DTexture?(Ye.setTexture3D(z,0),Fe=O.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ye.setTexture2DArray(z,0),Fe=O.TEXTURE_2D_ARRAY):(Ye.setTexture2D(z,0),Fe=O.TEXTURE_2D),Me.activeTexture(O.TEXTURE0),Me.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,z.flipY),Me.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Me.pixelStorei(O.UNPACK_ALIGNMENT,z.unpackAlignment);let mn=Me.getParameter(O.UNPACK_ROW_LENGTH),_t=Me.getParameter(O.UNPACK_IMAGE_HEIGHT),bs=Me.getParameter(O.UNPACK_SKIP_PIXELS),gn=Me.getParameter(O.UNPACK_SKIP_ROWS),eo=Me.getParameter(O.UNPACK_SKIP_IMAGES);Me.pixelStorei(O.UNPACK_ROW_LENGTH,It.width),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,It.height),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,ke),Me.pixelStorei(O.UNPACK_SKIP_ROWS,tt),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,dt);let is=T.isDataArrayTexture||T.isData3DTexture,Ss=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let ut=ze.get(T),rn=ze.get(z),Yn=ze.get(ut.__renderTarget),Dt=ze.get(rn.__renderTarget);Me.bindFramebuffer(O.READ_FRAMEBUFFER,Yn.__webglFramebuffer),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let _n=0;_n<Ie;_n++)is&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ze.get(T).__webglTexture,$,dt+_n),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ze.get(z).__webglTexture,Te,jt+_n)),O.blitFramebuffer(ke,tt,ke+Pe,tt+Ee,Be,pt,Be+Pe,pt+Ee,O.DEPTH_BUFFER_BIT,O.NEAREST);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if($!==0||T.isRenderTargetTexture||ze.has(T)){let ut=ze.get(T),rn=ze.get(z);Me.bindFramebuffer(O.READ_FRAMEBUFFER,F),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let Yn=0;Yn<Ie;Yn++)is?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ut.__webglTexture,$,dt+Yn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ut.__webglTexture,$),Ss?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,rn.__webglTexture,Te,jt+Yn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,rn.__webglTexture,Te),$!==0?O.blitFramebuffer(ke,tt,ke+Pe,tt+Ee,Be,pt,Be+Pe,pt+Ee,O.COLOR_BUFFER_BIT,O.NEAREST):Ss?O.copyTexSubImage3D(Fe,Te,Be,pt,jt+Yn,ke,tt,Pe,Ee):O.copyTexSubImage2D(Fe,Te,Be,pt,ke,tt,Pe,Ee);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Ss?T.isDataTexture||T.isData3DTexture?O.texSubImage3D(Fe,Te,Be,pt,jt,Pe,Ee,Ie,Lt,wn,It.data):z.isCompressedArrayTexture?O.compressedTexSubImage3D(Fe,Te,Be,pt,jt,Pe,Ee,Ie,Lt,It.data):O.texSubImage3D(Fe,Te,Be,pt,jt,Pe,Ee,Ie,Lt,wn,It):T.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Pe,Ee,Lt,wn,It.data):T.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Te,Be,pt,It.width,It.height,Lt,It.data):O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Pe,Ee,Lt,wn,It);Me.pixelStorei(O.UNPACK_ROW_LENGTH,mn),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,_t),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,bs),Me.pixelStorei(O.UNPACK_SKIP_ROWS,gn),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,eo),Te===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&O.generateMipmap(Fe),Me.unbindTexture()},this.initRenderTarget=function(T){ze.get(T).__webglFramebuffer===void 0&&Ye.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ye.setTextureCube(T,0):T.isData3DTexture?Ye.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ye.setTexture2DArray(T,0):Ye.setTexture2D(T,0),Me.unbindTexture()},this.resetState=function(){Y=0,G=0,oe=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Fi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var gv={type:"change"},hp={type:"start"},vv={type:"end"},hh=new Vr,_v=new yi,UA=Math.cos(70*Zd.DEG2RAD),Pn=new K,ai=2*Math.PI,Ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},up=1e-6,fh=class extends ll{constructor(e,t=null){super(e,t),this.state=Ct.NONE,this.target=new K,this.cursor=new K,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:gr.ROTATE,MIDDLE:gr.DOLLY,RIGHT:gr.PAN},this.touches={ONE:_r.ROTATE,TWO:_r.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new K,this._lastQuaternion=new xi,this._lastTargetPosition=new K,this._quat=new xi().setFromUnitVectors(e.up,new K(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Qo,this._sphericalDelta=new Qo,this._scale=1,this._panOffset=new K,this._rotateStart=new it,this._rotateEnd=new it,this._rotateDelta=new it,this._panStart=new it,this._panEnd=new it,this._panDelta=new it,this._dollyStart=new it,this._dollyEnd=new it,this._dollyDelta=new it,this._dollyDirection=new K,this._mouse=new it,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=BA.bind(this),this._onPointerDown=OA.bind(this),this._onPointerUp=kA.bind(this),this._onContextMenu=XA.bind(this),this._onMouseWheel=VA.bind(this),this._onKeyDown=HA.bind(this),this._onTouchStart=WA.bind(this),this._onTouchMove=qA.bind(this),this._onMouseDown=zA.bind(this),this._onMouseMove=GA.bind(this),this._interceptControlDown=YA.bind(this),this._interceptControlUp=$A.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(gv),this.update(),this.state=Ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Pn.copy(t).sub(this.target),Pn.applyQuaternion(this._quat),this._spherical.setFromVector3(Pn),this.autoRotate&&this.state===Ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ai:i>Math.PI&&(i-=ai),s<-Math.PI?s+=ai:s>Math.PI&&(s-=ai),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Pn.setFromSpherical(this._spherical),Pn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Pn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Pn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new K(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new K(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Pn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(hh.origin.copy(this.object.position),hh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(hh.direction))<UA?this.object.lookAt(this.target):(_v.setFromNormalAndCoplanarPoint(this.object.up,this.target),hh.intersectPlane(_v,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>up||8*(1-this._lastQuaternion.dot(this.object.quaternion))>up||this._lastTargetPosition.distanceToSquared(this.target)>up?(this.dispatchEvent(gv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ai/60*this.autoRotateSpeed*e:ai/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Pn.setFromMatrixColumn(t,0),Pn.multiplyScalar(-e),this._panOffset.add(Pn)}_panUp(e,t){this.screenSpacePanning===!0?Pn.setFromMatrixColumn(t,1):(Pn.setFromMatrixColumn(t,0),Pn.crossVectors(this.object.up,Pn)),Pn.multiplyScalar(e),this._panOffset.add(Pn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Pn.copy(s).sub(this.target);let r=Pn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new it,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function OA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function BA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function kA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(vv),this.state=Ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function zA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case gr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ct.DOLLY;break;case gr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}break;case gr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(hp)}function GA(n){switch(this.state){case Ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function VA(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ct.NONE||(n.preventDefault(),this.dispatchEvent(hp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(vv))}function HA(n){this.enabled!==!1&&this._handleKeyDown(n)}function WA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case _r.ROTATE:if(this.enableRotate===!1){this.state=Ct.NONE;break}this._handleTouchStartRotate(n),this.state=Ct.TOUCH_ROTATE;break;case _r.PAN:if(this.enablePan===!1){this.state=Ct.NONE;break}this._handleTouchStartPan(n),this.state=Ct.TOUCH_PAN;break;default:this.state=Ct.NONE}break;case 2:switch(this.touches.TWO){case _r.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ct.TOUCH_DOLLY_PAN;break;case _r.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ct.TOUCH_DOLLY_ROTATE;break;default:this.state=Ct.NONE}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(hp)}function qA(n){switch(this._trackPointer(n),this.state){case Ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ct.NONE}}function XA(n){this.enabled!==!1&&n.preventDefault()}function YA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function $A(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var yv=[[1,0],[0,1]],ZA=`
attribute vec3 real;
attribute vec3 imag;
attribute vec3 origin;
attribute vec2 turn;
uniform vec2 phase;
uniform float swing;
uniform mat3 turned;
uniform vec3 middle;
varying vec3 seen;
varying float amount;
void main() {
  vec3 first = real * turn.x - imag * turn.y;
  vec3 second = real * turn.y + imag * turn.x;
  amount = sqrt(dot(real, real) + dot(imag, imag));
  vec3 moved = turned * (position - middle + swing * (first * phase.x - second * phase.y)) + middle + origin;
  vec4 place = modelViewMatrix * vec4(moved, 1.0);
  seen = place.xyz;
  gl_Position = projectionMatrix * place;
}`,KA=`
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`,JA=`
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`,jA={oblique:[.45,-.8,.45],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},dh=class{constructor(e,t,i){this.data=e;this.canvas=t;this.renderer=new lh({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),this.vectors=e.header.extra.lattice_vectors,this.period=Math.hypot(...this.vectors[0]);let s=Float32Array.from(e.values("skin_position"),u=>u/this.period),r={position:new ei(s,3),real:new ei(new Float32Array(s.length),3),imag:new ei(new Float32Array(s.length),3)};for(let u of[this.surface,this.edges])for(let[f,h]of Object.entries(r))u.setAttribute(f,h);this.surface.setIndex(eC(e.values("skin_face"))),this.edges.setIndex(Array.from(e.values("skin_edge"))),this.box.setFromBufferAttribute(r.position),this.box.getCenter(this.uniforms.middle.value);let o=new Hr(Uint8Array.from(i.flatMap(([u=0,f=0,h=0])=>[u,f,h,255])),i.length,1);o.minFilter=o.magFilter=zn,o.needsUpdate=!0,this.uniforms.scale.value=o;let a={uniforms:this.uniforms,vertexShader:ZA},l=new Ui(this.surface,new Mi({...a,fragmentShader:KA,side:Oi,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),c=new tl(this.edges,new Mi({...a,fragmentShader:JA}));for(let u of[l,c])u.frustumCulled=!1,this.scene.add(u);this.camera.up.set(0,0,1),this.controls=new fh(this.camera,t),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.colourLines()}data;canvas;renderer;scene=new ja;camera=new Qn(28,1,.01,100);controls;uniforms={phase:{value:new it(1,0)},swing:{value:.15},turned:{value:new et},middle:{value:new K},scale:{value:new Hr(new Uint8Array(4),1,1)},ink:{value:new xt(0,0,0)}};surface=new Jo;edges=new Jo;period;vectors;box=new ps;copies=[1,1];kappa=[0,0];frames=0;turns=[];show({of:e,row:t,band:i,kappa:s,turn:r,isReversed:o}){let[,a=0,l=0]=this.data.shape(`${e}_mode_real`),c=(t*a+i)*l,u=this.data.values("path_shape");for(let y of["real","imag"]){let _=`${e}_mode_${y}`,g=this.data.values(_).subarray(c,c+l),E=(o&&y==="imag"?-1:1)*this.data.scale(_)*this.data.scale("path_shape"),S=this.surface.getAttribute(y);QA(S.array,u,g,E),S.needsUpdate=!0}let[[f,h],[d,p]]=r;this.uniforms.turned.value.set(f,h,0,d,p,0,0,0,1),this.kappa=s,this.place()}repeat(e){this.copies=e,this.place(),this.look("oblique")}set swing(e){this.uniforms.swing.value=e}turn(e){this.uniforms.phase.value.set(Math.cos(2*Math.PI*e),Math.sin(2*Math.PI*e)),this.draw()}draw(){this.frames++,this.renderer.render(this.scene,this.camera)}look(e){let[t,i]=this.copies,s=this.box.clone();for(let[c,u]of[[t-1,0],[0,i-1],[t-1,i-1]])s.union(this.box.clone().translate(this.shift(c,u)));let r=s.getBoundingSphere(new Fs),o=this.camera.fov*Math.PI/360,a=Math.atan(Math.tan(o)*Math.min(1,this.camera.aspect)),l=1.08*r.radius/Math.sin(a);this.controls.target.copy(r.center),this.camera.position.set(...jA[e]).normalize().multiplyScalar(l).add(r.center),this.camera.near=.01*l,this.camera.far=10*l,this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}resize(e,t){this.renderer.setPixelRatio(devicePixelRatio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix()}colourLines(){this.uniforms.ink.value.set(Qe("ink"))}dispose(){this.controls.dispose(),this.surface.dispose(),this.edges.dispose(),this.uniforms.scale.value.dispose(),this.renderer.dispose()}shift(e,t){let[[i,s],[r,o]]=this.vectors;return new K((e*i+t*r)/this.period,(e*s+t*o)/this.period,0)}place(){let[e,t]=this.copies,i=[],s=[];for(let r=0;r<e;r++)for(let o=0;o<t;o++){let a=r*this.kappa[0]+o*this.kappa[1];i.push(...this.shift(r,o).toArray()),s.push(Math.cos(a),Math.sin(a))}this.turns=s;for(let r of[this.surface,this.edges])r.instanceCount=e*t,r.setAttribute("origin",new Zo(Float32Array.from(i),3)),r.setAttribute("turn",new Zo(Float32Array.from(s),2))}};function QA(n,e,t,i){n.fill(0);for(let s=0;s<t.length;s++){let r=(t[s]??0)*i;if(r===0)continue;let o=s*n.length;for(let a=0;a<n.length;a++)n[a]+=r*e[o+a]}}function eC(n){let e=[];for(let t=0;t<n.length;t+=4){let[i,s,r,o]=n.subarray(t,t+4);e.push(i,s,r,i,r,o)}return e}var tC=[["oblique","oblique"],["x","along x"],["y","along y"],["z","from above"]];function ph({data:n,choice:e,motion:t,name:i}){let s=Nt(null),r=Nt(null),[o,a]=Zs("");return fn(()=>{if(s.current===null)return;let l;try{l=new dh(n,s.current,xv(n))}catch{a("The mode cannot be drawn, because this browser has no WebGL.");return}return r.current=l,Object.assign(s.current,{moving:l}),iC(l,t,e)},[n,e,t]),m("div",{class:"mode",children:[o?m("p",{role:"alert",children:o}):m("canvas",{ref:s,role:"img","aria-label":"The cell moving in the selected mode"}),m("p",{class:"scale",children:[m("span",{children:"0"}),m("span",{class:"bar",style:{background:nC(n)}}),m("span",{children:"1"})," displacement, relative to the largest"]}),m("p",{class:"sides",children:[m("span",{id:`seen-${i}`,children:"Seen"}),tC.map(([l,c])=>m("button",{type:"button",onClick:()=>r.current?.look(l),"aria-describedby":`seen-${i}`,children:c}))]}),m(Ro,{canvas:s,name:i,caption:`${n.header.title}, ${Vi(n)}`})]})}function xv(n){return n.header.extra.colours}function nC(n){return`linear-gradient(to right, ${xv(n).map(e=>`rgb(${e.join(" ")})`).join(", ")})`}function iC(n,e,t){let{canvas:i}=n,s=()=>n.turn(r.moment),r=new ir(t,s,i);Co(i,l=>r.at(l));let o=new ResizeObserver(()=>{n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1)),n.look("oblique")});n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1));let a=[Et(()=>n.repeat(t.copies.value)),Et(()=>{n.show(e.value),i.dataset.shown=`${e.value.row},${e.value.band}`,s()}),Et(()=>{n.swing=t.swing.value,s()}),si(()=>{n.colourLines(),n.draw()})];return o.observe(i),()=>{r.end(),o.disconnect();for(let l of a)l();n.dispose()}}function bv({diagram:n,unit:e}){let{factor:t}=e;return n.gaps.length===0?m("p",{children:"The computed bands have no gap."}):m("div",{class:"wide",children:m("table",{children:[m("caption",{children:"Gaps"}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"bands"}),m("th",{scope:"col",children:"where"}),m("th",{scope:"col",children:Xt("lower",e)}),m("th",{scope:"col",children:Xt("upper",e)})]})}),m("tbody",{children:n.gaps.map(i=>m("tr",{children:[m("td",{children:[i.waves==="all"?"":`${i.waves} `,i.below,"-",i.below+1]}),m("td",{children:i.complete?"everywhere (complete)":i.waves==="all"?`${i.direction} only`:"everywhere, these waves only"}),m("td",{children:Gt(i.lower/t,i.lowerError/t)}),m("td",{children:Gt(i.upper/t,i.upperError/t)})]}))})]})})}function Sv({diagram:n,choice:e}){let{row:t,band:i}=e.point.value,s=e.unit.value,{factor:r}=s,o=Array.from({length:n.bands},(a,l)=>({row:t,band:l}));return m("div",{class:"wide",children:m("table",{children:[m("caption",{children:["Modes at ",n.place(t)]}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"band"}),m("th",{scope:"col",children:Xt("frequency",s)}),m("th",{scope:"col",children:"motion"}),m("th",{scope:"col",children:"symmetry"}),m("th",{scope:"col",children:"show"})]})}),m("tbody",{children:o.map(a=>m("tr",{"aria-current":a.band===i?"true":void 0,children:[m("td",{children:a.band+1}),m("td",{children:Gt(n.at(a)/r,n.errorAt(a)/r)}),m("td",{children:n.nature(a)}),m("td",{children:n.parity(a)}),m("td",{children:m("button",{type:"button",onClick:()=>e.point.value=a,children:["band ",a.band+1]})})]}))})]})})}var sC=[1,2,5,10],rC=.7,mh=class{constructor(e){this.data=e;this.places=e.values("zone_wavevector"),this.samples=e.values("zone_sample"),this.frequency=e.values("zone_frequency"),this.error=e.values("zone_error"),[,this.bands=0]=e.shape("zone_frequency");let t=Array.from(e.values("zone_mesh"));this.triangles=Array.from({length:t.length/3},(i,s)=>t.slice(3*s,3*s+3)),this.corners=e.header.extra.zone,this.colours=e.header.extra.colours,this.reach=Math.max(...Array.from(this.places,Math.abs))}data;bands;triangles;corners;colours;reach;places;samples;frequency;error;wavevector(e){return[this.places[2*e]??NaN,this.places[2*e+1]??NaN]}sample(e){return this.samples[e]??0}phases(e){let t=this.data.values("zone_kappa");return[t[2*e]??NaN,t[2*e+1]??NaN]}at(e,t){return this.frequency[e*this.bands+t]??NaN}errorAt(e,t){return this.error[e*this.bands+t]??NaN}get hasModes(){return this.data.has("zone_mode_real")}motion(e,t){let[i,s]=this.turned(e),[r,o]=this.wavevector(e),a=this.data.header.extra.lattice_vectors,[l,c]=a.map(([u,f])=>r*u+o*f);return{of:"zone",row:this.sample(e),band:t,kappa:[l??0,c??0],turn:i,isReversed:s}}velocity(e,t){let i=2*(this.sample(e)*this.bands+t),[s,r]=[this.data.values("zone_velocity")[i]??NaN,this.data.values("zone_velocity")[i+1]??NaN],[[[o,a],[l,c]],u]=this.turned(e),f=u?-1:1;return Number.isFinite(s)&&Number.isFinite(r)?[f*(o*s+a*r),f*(l*s+c*r)]:void 0}velocityError(e,t){return this.data.values("zone_velocity_error")[this.sample(e)*this.bands+t]??NaN}described(e,t){let i=this.sample(e),s=o=>this.data.values(o)[i*this.bands+t];return{motion:s("zone_character"),symmetry:Bf(s("zone_parity"),"the mirror of the wavevector",s("zone_middle_parity"))}}turned(e){let t=Math.floor(e/this.count),i=this.data.header.extra.zone_turns[t];if(i===void 0)throw new Error(`the zone has no copy ${t}`);return[i,this.data.header.extra.zone_signs[t]===-1]}mean(e,t){return e.reduce((i,s)=>i+this.at(this.sample(s),t),0)/3}range(e){let t=Array.from({length:this.frequency.length/this.bands},(i,s)=>this.at(s,e));return[Math.min(...t),Math.max(...t)]}get count(){return this.frequency.length/this.bands}highest(e){return this.all.reduce((t,i)=>this.at(this.sample(i),e)>this.at(this.sample(t),e)?i:t,0)}nearest([e,t]){let i=s=>Math.hypot(this.wavevector(s)[0]-e,this.wavevector(s)[1]-t);return this.all.reduce((s,r)=>i(r)<i(s)?r:s,0)}next(e,t,i){let[s,r]=this.wavevector(e),[o,a]=[e,1/0];for(let l of this.all){let[c,u]=[this.wavevector(l)[0]-s,this.wavevector(l)[1]-r],f=Math.hypot(c,u),h=(c*t+u*i)/f;f>1e-9*this.reach&&h>rC&&f/h**2<a&&([o,a]=[l,f/h**2])}return o}contour(e,t){let i=[];for(let s of this.triangles){let r=[];s.forEach((o,a)=>{let l=s[(a+1)%3]??0,[c,u]=[this.at(this.sample(o),e),this.at(this.sample(l),e)];if(c<t==u<t)return;let f=(t-c)/(u-c),[h,d]=[this.wavevector(o),this.wavevector(l)];r.push([h[0]+f*(d[0]-h[0]),h[1]+f*(d[1]-h[1])])}),r[0]&&r[1]&&i.push([r[0],r[1]])}return i}get all(){return Array.from(this.samples,(e,t)=>t)}};function fp(n,e,t){if(!(e>n))return[];let i=10**Math.floor(Math.log10((e-n)/t)),s=i*(sC.find(o=>o*i*t>=e-n)??10),r=Math.ceil(n/s);return Array.from({length:Math.floor(e/s)-r+1},(o,a)=>(r+a)*s)}var Mv=440,oC=26,wv=8,gh=34;function Tv({diagram:n,choice:e}){return n.data.has("zone_wavevector")?m(aC,{diagram:n,choice:e}):null}function aC({diagram:n,choice:e}){let t=Ge(()=>new mh(n.data),[n]),i=Ge(()=>({image:Xe(t.highest(e.point.peek().band))}),[t,e]),s=Ge(()=>lC(n,t,i,e),[n,t,i,e]),r=Ge(()=>xn(()=>t.motion(i.image.value,e.point.value.band)),[t,i,e]),{band:o}=e.point.value;return m("section",{"aria-label":"Brillouin zone",class:"pair",children:[m("div",{children:[m(Vn,{label:"Brillouin zone. Arrow keys move the wavevector, page keys change the band.",describedBy:"zone-point",onKeyDown:a=>{Hl(a,s),a.defaultPrevented&&a.stopPropagation()},children:m(cC,{zone:t,band:o,own:i})}),m("p",{class:"axes",children:m("label",{children:["Band"," ",m("select",{value:o+1,onChange:({currentTarget:a})=>e.point.value={...e.point.value,band:a.selectedIndex},children:Array.from({length:n.bands},(a,l)=>m("option",{children:l+1}))})]})}),m(dC,{zone:t,diagram:n,band:o,unit:e.unit.value}),m(pC,{diagram:n,zone:t,own:i,choice:e})]}),t.hasModes&&m("div",{children:[m(ph,{data:n.data,choice:e,motion:r,name:"zone-mode"}),m("p",{class:"sides",children:m(Cr,{playing:e.playing})})]})]})}function lC(n,e,t,i){let s=o=>()=>i.point.value=uc(n,i.point.value,0,o),r=(o,a)=>()=>t.image.value=e.next(t.image.value,o,a);return[{keys:"arrows",effect:"next wavevector",actions:{ArrowLeft:r(-1,0),ArrowRight:r(1,0),ArrowUp:r(0,1),ArrowDown:r(0,-1)}},{keys:"page up, page down",effect:"next higher or lower band",actions:{PageUp:s(1),PageDown:s(-1)}}]}function cC({zone:n,band:e,own:t}){let i=Nt(null),s=t.image.value,r=()=>{i.current!==null&&uC(i.current,n,e,s)};Gi(r),fn(()=>{let a=i.current?.parentElement;if(!a)return;let l=new ResizeObserver(()=>o.current());l.observe(a);let c=si(()=>o.current());return()=>{l.disconnect(),c()}},[]);let o=Nt(r);return o.current=r,m("div",{class:"map zone",children:m("canvas",{ref:i,role:"img","aria-label":`Frequency of band ${e+1} over the zone`,onClick:({offsetX:a,offsetY:l,currentTarget:c})=>{let{toWavevector:u}=Ev(c,n);t.image.value=n.nearest(u(a,l))}})})}function Ev(n,e){let t=n.clientWidth,i=(t-2*oC)/(2*e.reach);return{toPixel:([s,r])=>[t/2+i*s,t/2-i*r],toWavevector:(s,r)=>[(s-t/2)/i,(t/2-r)/i]}}function uC(n,e,t,i){let s=Math.min(n.parentElement?.clientWidth??Mv,Mv);n.style.width=n.style.height=`${s}px`,n.width=n.height=Math.round(s*devicePixelRatio);let r=n.getContext("2d");if(r===null)return;r.scale(devicePixelRatio,devicePixelRatio);let{toPixel:o}=Ev(n,e),[a,l]=e.range(t);for(let u of e.triangles){let f=e.colours[Math.round((e.mean(u,t)-a)/(l-a||1)*(e.colours.length-1))];r.fillStyle=r.strokeStyle=`rgb(${(f??[]).join(" ")})`,r.beginPath();for(let h of u)r.lineTo(...o(e.wavevector(h)));r.closePath(),r.fill(),r.stroke()}r.strokeStyle="#ffffff",r.lineWidth=1,r.beginPath();for(let u of fp(a,l,wv))for(let[f,h]of e.contour(t,u))r.moveTo(...o(f)),r.lineTo(...o(h));r.stroke(),fC(r,e,o);let c=e.hasModes?e.velocity(i,t):void 0;c!==void 0&&Math.hypot(...c)>e.velocityError(i,t)&&hC(r,o(e.wavevector(i)),c),r.beginPath(),r.arc(...o(e.wavevector(i)),5,0,2*Math.PI),r.fillStyle=Qe("accent"),r.strokeStyle="#ffffff",r.lineWidth=2,r.fill(),r.stroke(),n.dataset.shown=`${i},${t}`,Object.assign(n,{zone:e})}function hC(n,[e,t],[i,s]){let r=Math.hypot(i,s),[o,a]=[i/r,-s/r],l=(c,u)=>[e+c*o-u*a,t+c*a+u*o];for(let[c,u]of[["#ffffff",5],[Qe("accent"),2.5]])n.strokeStyle=c,n.lineWidth=u,n.beginPath(),n.moveTo(e,t),n.lineTo(...l(gh,0)),n.moveTo(...l(gh-8,5)),n.lineTo(...l(gh,0)),n.lineTo(...l(gh-8,-5)),n.stroke()}function fC(n,e,t){n.strokeStyle=Qe("carrier"),n.setLineDash([5,4]),n.lineWidth=1.5,n.beginPath();for(let r of Object.values(e.corners))n.lineTo(...t(r));n.closePath(),n.stroke(),n.setLineDash([]),n.font="15px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.lineWidth=3,n.strokeStyle=Qe("paper"),n.fillStyle=Qe("ink");let i=Object.values(e.corners),s=[0,1].map(r=>i.reduce((o,a)=>o+(a[r]??0),0)/i.length);for(let[r,o]of Object.entries(e.corners)){let[a,l]=t(o),[c,u]=[Math.sign(o[0]-(s[0]??0)),Math.sign(o[1]-(s[1]??0))];n.strokeText(r,a+13*c,l-13*u),n.fillText(r,a+13*c,l-13*u)}}function dC({zone:n,diagram:e,band:t,unit:i}){let[s,r]=n.range(t).map(u=>ls(Number((u/i.factor).toPrecision(4)))),a=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(u=>`rgb(${(n.colours[u]??[]).join(" ")})`),l=fp(...n.range(t),wv),c=((l[1]??0)-(l[0]??0))/i.factor;return m("p",{class:"scale",children:[m("span",{children:s}),m("span",{class:"bar",style:{background:`linear-gradient(to right, ${a.join(", ")})`}}),m("span",{children:r})," ",Xt("frequency",i)," of band ",t+1," of ",e.bands,l.length>1&&`; contours every ${Number(c.toPrecision(4))}`]})}function pC({diagram:n,zone:e,own:t,choice:i}){let[s,r,o]=[t.image.value,i.wavevectorUnit.value,i.unit.value],{band:a}=i.point.value,[l,c]=e.wavevector(s).map(p=>Number((p/r.factor).toFixed(3))),u=e.sample(s),f=p=>Gt(e.at(u,p)/o.factor,e.errorAt(u,p)/o.factor),[h,d]=e.phases(u).map(p=>Number((p/Math.PI).toFixed(4)));return m("div",{class:"facts",children:[m("p",{id:"zone-point","aria-live":"polite",children:["Band ",a+1," at (",l,", ",c,") ",r.name,": ",m("b",{children:kn(f(a),o)})]}),e.hasModes&&m(ln,{children:[m(Ii,{facts:mC(n,e,s,a)}),m("p",{class:"again",children:["The arrow in the zone is the direction of the group velocity. Bands and modes are computed at ",e.count," ","wavevectors of the irreducible zone; a click selects the nearest one or its image."]})]}),m("details",{children:[m("summary",{children:"Frequencies of all bands at this wavevector"}),m("div",{class:"wide",children:m("table",{children:[m("caption",{children:"Frequencies at this wavevector"}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"band"}),m("th",{scope:"col",children:Xt("frequency",o)})]})}),m("tbody",{children:Array.from({length:e.bands},(p,y)=>m("tr",{"aria-current":y===a?"true":void 0,children:[m("td",{children:y+1}),m("td",{children:f(y)})]}))})]})})]}),m("p",{class:"again",children:["Its modes as a picture: ",m("code",{children:['haptonic bands STUDY --modes-at "',h,", ",d,'"']})]})]})}function mC(n,e,t,i){let[{motion:s,symmetry:r},o]=[e.described(t,i),e.velocity(t,i)];return[["motion",n.motion(s)],["symmetry",r],["group velocity",o?Wl(o,e.velocityError(t,i)):"not defined"]]}function Cv(n,e){return m(_C,{data:n,host:e})}var gC="Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of the model.";function _C({data:n,host:e}){let t=Ge(()=>new oc(n),[n]),i=Ge(()=>s_(t),[t.rows,t.bands]),s=Ge(()=>vC(t,i),[t,i]),r=Ge(()=>Kg(e?.turned),[e]),o=()=>{let y=r.layer.peek()??ac(t);i.held.value!==null?i.held.value=null:!y.isPreview&&!r.isWaiting.peek()&&(i.held.value={layer:y,gaps:y.gaps,carrier:t.carrier,design:e?.design()??{}})},a=Ge(()=>a_(t,i,e&&o),[t,i,e]),l=r.layer.value,c=r.isWaiting.value?"earlier design":l?.isPreview?"preview":"certified",u=r.isWaiting.value||l!==null,f=i.held.value,{carrier:h}=t,d=t.units.find(({name:y})=>y===i.unit.value.name)??i.unit.value,p=(l??t).gaps;return m(Jn,{name:"bands",data:n,keys:a,foot:gC,isOld:u,children:[m("div",{class:"insight",children:[e?.controls,m("span",{class:`kind ${c}`,children:c}),e&&m("button",{type:"button",class:"minor","aria-label":"Hold this design","aria-pressed":f!==null,disabled:c!=="certified"&&f===null,onClick:o,children:"Hold"}),c==="earlier design"?m("p",{children:[e?.turned.value?.data?"Too far for a preview.":"No preview yet."," Certified curves follow."]}):m(n_,{gaps:p,carrier:h,unit:d})]}),m("div",{class:"pair",children:[m("section",{"aria-label":"Band diagram",children:[m(Vn,{label:"Band diagram. Arrow keys move along the path and between bands.",children:m(Jg,{diagram:t,choice:i,newer:r})}),m("p",{class:"axes",children:[m(Pi,{title:"Frequencies in",units:t.units,unit:i.unit}),m(Pi,{title:"Wavevectors in",units:t.wavevectorUnits,unit:i.wavevectorUnit}),m(yC,{diagram:t,isPreview:c==="preview",isHeld:f!==null})]}),f!==null&&e&&c!=="earlier design"&&m(i_,{held:f,now:{gaps:p,carrier:h,design:e.design()},unit:d,isPreview:c==="preview",drop:o})]}),m("section",{"aria-label":"Mode",children:[m(ph,{data:n,choice:i,motion:s,name:"mode"}),m(xC,{diagram:t,choice:i,isOld:u}),m(bC,{choice:i})]})]}),m(Tv,{diagram:t,choice:i}),m(ii,{listing:i.listing,keys:a,children:[m(bv,{diagram:t,unit:i.unit.value}),m(Sv,{diagram:t,choice:i})]})]})}function vC(n,e){return xn(()=>{let{row:t,band:i}=e.point.value;return{of:"path",row:t,band:i,kappa:n.phases(t),turn:yv,isReversed:!1}})}function yC({diagram:n,isPreview:e,isHeld:t}){return m("span",{class:"legend",children:[n.gaps.some(i=>i.complete)&&m("span",{class:"of-gap",children:"complete gap"}),n.gaps.some(i=>i.waves!=="all")&&m("span",{class:"of-parity",children:"gap of one parity"}),n.carrier!==void 0&&m("span",{class:"of-carrier",children:"carrier"}),e&&m("span",{class:"of-preview",children:"preview with its error"}),t&&m("span",{class:"of-held",children:"held design"})]})}function xC({diagram:n,choice:e,isOld:t}){let i=e.point.value,s=e.unit.value,r=n.velocity(i),o=[["motion",n.nature(i)],["symmetry",n.parity(i)],["group velocity",r?Wl(r,n.velocityError(i)):"not defined"]],a=n.place(i.row);return m("div",{class:"facts",children:[m("p",{id:"point","aria-live":"polite",children:["Band ",i.band+1," at ",a,t&&", earlier design",": ",m("b",{children:kn(Gt(n.at(i)/s.factor,n.errorAt(i)/s.factor),s)})]}),m(Ii,{facts:o}),m("p",{class:"again",children:["The same mode as a picture: ",m("code",{children:['haptonic bands STUDY --modes-at "',a,'"']})," or, in Python,"," ",m("code",{children:['study.bands(modes_at="',a,'").plot("modes")']})]})]})}function bC({choice:n}){let[e,t]=n.copies.value;return m("div",{class:"controls",children:[m(Cr,{playing:n.playing}),m("label",{children:["largest displacement, share of the period: ",n.swing.value.toFixed(2),m("input",{type:"range",min:"0",max:cc,step:"0.01",value:n.swing.value,onInput:i=>n.swing.value=Number(i.currentTarget.value)})]}),m(Ca,{pace:n.pace}),m("label",{children:["cells along a1",m("input",{type:"number",min:"1",max:lc,value:e,onChange:i=>n.copies.value=[Av(i.currentTarget.value),t]})]}),m("label",{children:["cells along a2",m("input",{type:"number",min:"1",max:lc,value:t,onChange:i=>n.copies.value=[e,Av(i.currentTarget.value)]})]})]})}function Av(n){let e=Math.round(Number(n));return Number.isFinite(e)?Math.min(Math.max(e,1),lc):1}var SC={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"};function es(n){let{x:e,curves:t,titles:i,height:s,limits:r,whole:o}=n,a=Nt(null),l=Nt(n);l.current=n;let c=Nt(null);return Gi(()=>{let u=a.current;if(u===null)return;let f={...SC,stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")},grid:{show:!1}},h=()=>({width:er(u),height:s}),d=new Qt({...h(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(p,y,_)=>y===null?r?.x??[0,1]:[y,_]},y:{range:(p,y,_)=>y===null?r?.y??[0,1]:[y,_]}},axes:[{...f,label:i[0],labelSize:22,size:34,...o?{incrs:[1,2,5,10]}:{}},{...f,label:i[1],labelSize:24,size:52}],series:[{},...t.map(({colour:p,dash:y,width:_,points:g})=>({stroke:()=>Qe(p),fill:()=>"transparent",dash:y??[],width:g?0:_??1.4,points:g?{show:!0,size:4,fill:()=>Qe(p),width:0}:{show:!1}}))],hooks:{drawClear:[p=>nr(p,()=>l.current.below?.(p))],draw:[p=>nr(p,()=>l.current.above?.(p))]}},[e,...t.map(({values:p})=>p)],u);return r?.x&&d.setScale("x",{min:r.x[0],max:r.x[1]}),r?.y&&d.setScale("y",{min:r.y[0],max:r.y[1]}),Eo(d,(p,y)=>l.current.pick?.(d.posToVal(p,"x"),d.posToVal(y,"y"),d)),c.current=d,tr(d,u,h,[])},[e,t,i[0],i[1]]),Gi(()=>c.current?.redraw(!1,!1)),m("div",{class:"curves",ref:a})}var xr=class n{constructor(e,t,i,s){this.canvas=e;this.context=t;this.small=i;this.inner=s;this.image=new ImageData(i.width,i.height)}canvas;context;small;inner;image;static on(e,t,i){let s=new OffscreenCanvas(t,i),[r,o]=[e.getContext("2d"),s.getContext("2d")];return r===null||o===null?null:new n(e,r,s,o)}show(e){let{canvas:t,context:i}=this;this.inner.putImageData(this.image,0,0),i.clearRect(0,0,t.width,t.height),i.imageSmoothingEnabled=e,i.imageSmoothingQuality="high",i.drawImage(this.small,0,0,t.width,t.height)}follow(e,t){let{canvas:i}=this,s=()=>{let o=Math.min(i.parentElement?.clientWidth??300,.62*innerHeight/e);i.style.width=`${o}px`,i.style.height=`${o*e}px`,i.width=Math.round(o*devicePixelRatio),i.height=Math.round(o*e*devicePixelRatio),t()},r=new ResizeObserver(s);return i.parentElement!==null&&r.observe(i.parentElement),()=>r.disconnect()}};function aa({grid:n,part:e,wave:t,pace:i,label:s,name:r,caption:o}){let a=Nt(null);return fn(()=>a.current===null?void 0:MC(a.current,new dp(n,e),t,i),[n,e,t,i]),m("div",{class:"map",children:[m("canvas",{ref:a,role:"img","aria-label":s}),m(Ro,{canvas:a,name:r,caption:o})]})}function MC(n,e,t,i){let s=xr.on(n,e.columns,e.rows);if(s===null)return()=>{};let r={frames:0,painter:e},o=()=>{r.frames++,e.paint(s.image,t.peek(),a.moment),s.show(!0);for(let c of t.peek().edges??[]){let u=(1-c)*n.height;Qs(s.context,[0,u],[n.width,u],"quiet",[6,5])}n.dataset.shown=String(t.peek().number)},a=new ir(i,o,n);Co(n,c=>a.at(c)),Object.assign(n,{counted:r});let l=[s.follow(e.ratio,o),Et(()=>{t.value,o()}),si(o)];return()=>{a.end();for(let c of l)c()}}var dp=class{constructor(e,t){this.grid=e;this.part=t;let{repeats:i=1,periods:s}=t;this.columns=s*e.along,this.rows=i*e.across,this.ratio=i*e.width/(s*e.length)}grid;part;columns;rows;ratio;paint(e,{number:t,phase:i,decay:s},r){let{real:o,imag:a,present:l,across:c,along:u,colours:f}=this.grid,h=(f.length-1)/2,d=t*c*u;for(let p=0;p<this.columns;p++){let y=Math.floor(p/u),_=2*Math.PI*r+y*i,g=Math.exp(-y*s),[b,E]=[g*Math.cos(_),g*Math.sin(_)],S=Math.round(y*(this.part.slip??0)*c);for(let P=0;P<this.rows;P++){let v=((P-S)%c+c)%c*u+p%u,A=(o[d+v]??0)*b-(a[d+v]??0)*E,B=Math.min(Math.max(Math.round(h+A),0),2*h),[N=0,L=0,k=0]=f[B]??[],V=4*((this.rows-1-P)*this.columns+p);e.data.set([N,L,k,l[v]===0?0:255],V)}}}};var wC=12,_h=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;[this.count=0]=e.shape("frequency"),this.best=Number(t.best),this.mode=String(i.mode),this.ends=String(i.ends),this.frequencyError=Number(i.relative_frequency_error),this.units=Ci(e),this.period=Number(i.period);let[,s=0,r=0]=e.shape("mode_real"),[o=0,a=0]=e.values("across");this.fields={grid:{real:e.values("mode_real"),imag:e.values("mode_imag"),present:e.values("present"),across:s,along:r,width:(a-o)*s,length:this.period,colours:t.colours},part:{periods:wC}}}data;count;best;mode;ends;frequencyError;units;fields;period;value(e,t){return this.data.values(e)[t]??NaN}wave(e){let t=.5*this.value("width",e)/this.fields.grid.width;return{number:e,phase:this.value("phase",e),decay:0,edges:[.5-t,.5+t]}}profile(e){let{real:t,imag:i,across:s,along:r}=this.fields.grid,o=Array.from({length:s},(l,c)=>{let u=(e*s+c)*r,f=0;for(let h=u;h<u+r;h++)f+=(t[h]??0)**2+(i[h]??0)**2;return Math.sqrt(f)}),a=Math.max(...o);return{position:Array.from(this.data.values("across")),size:o.map(l=>l/a)}}};function Rv(n){return m(TC,{data:n})}function TC({data:n}){let e=Ge(()=>new _h(n),[n]),t=Ge(()=>({guide:Xe(e.best),unit:Xe(Ri(e.units,e.value("frequency",e.best))),...hs(),listing:Xe("none")}),[e]),i=Ge(()=>AC(e,t),[e,t]),s=Ge(()=>xn(()=>e.wave(t.guide.value)),[e,t]),{grid:r,part:o}=e.fields;return m(Jn,{name:"guides",data:n,keys:i,foot:EC(e),children:[m("div",{class:"pair",children:[m("section",{"aria-label":"Waveguides",children:[m(Vn,{label:"Waveguides. Arrow keys select another length.",children:[e.count>1&&m(CC,{guides:e,choice:t}),m(PC,{guides:e,choice:t})]}),m("p",{class:"axes",children:m(Pi,{title:"Frequencies in",units:e.units,unit:t.unit})}),m(IC,{guides:e,choice:t})]}),m("section",{"aria-label":"Mode",children:[m(aa,{grid:r,part:o,wave:s,pace:t,label:"Field of the guided mode, the strip from left to right between rows of the lattice",name:"waveguide",caption:`${n.header.title}, ${Vi(n)}`}),m(po,{...t})]})]}),m(ii,{listing:t.listing,keys:i,children:m(LC,{guides:e,choice:t})})]})}function EC(n){return`Frequencies of the lattice have errors of up to ${(100*n.frequencyError).toPrecision(2)} %, which move all frequencies of the waveguides alike; the conditions at their ${n.ends} ends are approximate. The field is the displacement normal to the flat face, of a wave that travels to the left; two opposite ones form the mode of the strip. Dashed lines are the edges of the strip.`}function AC(n,e){let t=i=>()=>e.guide.value=Math.min(Math.max(e.guide.value+i,0),n.count-1);return[{keys:"← →",effect:"next shorter or longer waveguide",actions:{ArrowLeft:t(-1),ArrowRight:t(1)}},{keys:"b",effect:"waveguide nearest to the carrier",actions:{b:()=>e.guide.value=n.best}},cs(e),...ni(e.listing)]}function CC({guides:n,choice:e}){let t=Ge(()=>Array.from({length:n.count},(c,u)=>u),[n]),[i,s]=Ge(()=>["length","width"].map(c=>t.map(u=>1e3*n.value(c,u))),[n,t]),r=Ge(()=>[{values:s,colour:"quiet",dash:[2,4]}],[s]),o=(c,u)=>[Math.min(...c)-u,Math.max(...c)+u],a=c=>{for(let u of t){let f=[c.valToPos(i[u]??0,"x",!0),c.valToPos(s[u]??0,"y",!0)];As(c.ctx,f,u===e.guide.value?"accent":"quiet",u===e.guide.value?6:4)}},l=.08*(Math.max(...s)-Math.min(...s))||1;return m(es,{x:i,curves:r,titles:["length / mm","width / mm"],height:240,limits:{x:o(i,500*n.period),y:o(s,l)},above:a,pick:c=>e.guide.value=RC(i,c)})}function RC(n,e){return n.reduce((t,i,s)=>Math.abs(i-e)<Math.abs((n[t]??NaN)-e)?s:t,0)}function PC({guides:n,choice:e}){let t=e.guide.value,{position:i,size:s}=Ge(()=>n.profile(t),[n,t]),r=Ge(()=>i.map(l=>1e3*l),[i]),o=Ge(()=>[{values:s,colour:"accent",width:2}],[s]),a=500*n.value("width",t);return m(es,{x:r,curves:o,titles:["from the middle of the strip / mm","rms over its peak"],height:220,limits:{x:[r[0]??0,r[r.length-1]??1],y:[0,1.05]},below:l=>{Fr(l,[r[0]??0,-a],"panel"),Fr(l,[a,r[r.length-1]??0],"panel")},above:l=>[-a,a].forEach(c=>js(l,c,"ink",[4,4]))},t)}function IC({guides:n,choice:e}){let[t,i]=[e.guide.value,e.unit.value],s=(o,a)=>`${(1e3*n.value(o,t)).toFixed(a)} mm`,r=[["width",s("width",2)],["length",`${s("length",1)}, ${n.value("rows",t)} cells`],["distance of nodal lines",s("nodal_spacing",3)],["amplitude at the edge",`${(100*n.value("amplitude_at_edge",t)).toFixed(1)} % of the peak`],["decay in the lattice",`${Iv(n,t)} dB per row`]];return m("div",{class:"facts",children:[m("p",{id:"point","aria-live":"polite",children:["Mode ",n.mode,", ",n.value("rows",t)," cells long: ",m("b",{children:kn(Pv(n,t,i),i)})]}),m(Ii,{facts:r})]})}function Pv(n,e,{factor:t}){let i=n.value("frequency",e)/t;return Gt(i,n.frequencyError*i)}var Iv=(n,e)=>Gt(n.value("decay",e),n.value("decay_error",e));function LC({guides:n,choice:e}){let t=e.unit.value;return m("div",{class:"wide",children:m("table",{children:[m("caption",{children:["Waveguides for mode ",n.mode]}),m("thead",{children:m("tr",{children:["cells","length / mm","width / mm",Xt("frequency",t),"decay / (dB/row)","edge / peak","show"].map(i=>m("th",{scope:"col",children:i}))})}),m("tbody",{children:Array.from({length:n.count},(i,s)=>m("tr",{"aria-current":s===e.guide.value?"true":void 0,children:[m("td",{children:n.value("rows",s)}),m("td",{children:(1e3*n.value("length",s)).toFixed(1)}),m("td",{children:(1e3*n.value("width",s)).toFixed(2)}),m("td",{children:Pv(n,s,t)}),m("td",{children:Iv(n,s)}),m("td",{children:n.value("amplitude_at_edge",s).toFixed(3)}),m("td",{children:m("button",{type:"button",onClick:()=>e.guide.value=s,children:[n.value("rows",s)," cells"]})})]}))})]})})}var DC=250,Lv=1e6,NC=["low","high","value"];function Dv({data:n,finger:e}){let t=Nt(null);return Gi(()=>{if(t.current!==null)return FC(t.current,n,e)},[n,e]),m(ln,{children:[m("div",{class:"curves",ref:t}),m("p",{class:"legend",children:[m("span",{class:"of-curve",children:[m("svg",{width:"34",height:"8","aria-hidden":"true",children:m("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:"var(--curve-0)"})})," ","model"]}),m("span",{class:"of-gap",children:"its interval"}),m("span",{class:"of-carrier",children:"people notice less than this"})]})]})}function FC(n,e,t){let i=Array.from(e.amplitudes,c=>c*Lv),s=()=>[i,...NC.map(c=>Array.from(t.law.value[c]))],r={stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},o=()=>({width:er(n),height:DC}),a={width:0,points:{show:!1}},l=new Qt({...o(),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,distr:3},y:{range:[0,1.02]}},bands:[{series:[2,1],fill:()=>Qe("gap")}],axes:[{...r,label:`${e.data.title("table")} / µm`,labelSize:22,size:34,values:(c,u)=>u.map(f=>Number.isInteger(Math.round(1e6*Math.log10(f))/1e6)?String(f):"")},{...r,label:e.data.title("load_sharing"),labelSize:24,size:50}],series:[{},a,a,{stroke:()=>Qe("curve-0"),width:2,points:{show:!1}}],hooks:{draw:[c=>UC(c,e,t)]}},s(),n);return tr(l,n,o,[Et(()=>l.setData(s())),Et(()=>{t.below.value,l.redraw(!1,!1)})])}function UC(n,e,t){let{ctx:i,bbox:s,valToPos:r}=n,{amplitude:o,friction:a}=t.below.peek(),[l,c]=[r(Math.max(o.value*Lv,.001),"x",!0),r(a.value,"y",!0)];To(n,1-e.extra.weber,"carrier",[7,5]),Qs(i,[l,s.top],[l,s.top+s.height],"accent"),i.save(),i.fillStyle=Qe("accent"),i.beginPath(),i.arc(l,c,5*devicePixelRatio,0,2*Math.PI),i.fill(),i.restore()}var Nv=["value","low","high"],vh=class{constructor(e){this.data=e;this.extra=e.header.extra,this.forces=e.values("force"),this.speeds=e.values("speed"),this.amplitudes=e.values("table"),this.x=e.values("x"),this.y=e.values("y"),this.columns=[...new Set(this.x)].sort((s,r)=>s-r),this.rows=[...new Set(this.y)].sort((s,r)=>s-r),this.cells=new Int32Array(this.columns.length*this.rows.length).fill(-1);let[t,i]=[this.columns,this.rows].map(s=>new Map(s.map((r,o)=>[r,o])));this.x.forEach((s,r)=>{this.cells[(i?.get(this.y[r]??0)??0)*this.columns.length+(t?.get(s)??0)]=r})}data;extra;forces;speeds;amplitudes;x;y;columns;rows;cells;get count(){return this.x.length}placeIn(e,t){if(t<0||t>=this.columns.length)return null;let i=this.cells[e*this.columns.length+t]??-1;return i<0?null:i}nearest([e,t]){let[i,s]=[0,1/0];for(let r=0;r<this.count;r++){let o=((this.x[r]??0)-e)**2+((this.y[r]??0)-t)**2;o<s&&([i,s]=[r,o])}return i}beside(e,t,i){let[s,r]=[this.rows.indexOf(this.y[e]??0),this.columns.indexOf(this.x[e]??0)];return this.placeIn(s+i,r+t)??e}region(e){return this.data.texts("region")[e]||"a lattice"}amplitude(e,t,i){let s=this.data.texts("load").indexOf(t);return i*(this.data.values("amplitude")[s*this.count+e]??0)}law(e,t){let i=this.amplitudes.length,s=this.data.texts("end"),r=(c,u)=>{let f=this.data.values(c);return h=>{let d=(u*s.length+s.indexOf(h))*i;return f.subarray(d,d+i)}},[o,a]=[r("load_sharing",e),r("intermittent",t)],l=(c,u)=>{let[f,h]=[o(c),a(c)];return Float64Array.from(f,(d,p)=>Number.isNaN(d)?h[p]??NaN:u(d,h[p]??NaN))};return{value:l("value",c=>c),low:l("low",Math.min),high:l("high",Math.max)}}friction(e,t){let[i=1,s=1]=[this.amplitudes[0],this.amplitudes.at(-1)],r=e.length-1,o=Math.log(Math.max(t,i)/i)/Math.log(s/i)*r,a=Math.min(Math.floor(o),r-1),l=Math.min(o-a,1);return(e[a]??NaN)*(1-l)+(e[a+1]??NaN)*l}};function Fv(n,e){return n.low>e?"noticed, also at the lower limit":n.value>e?"probably noticed; the lower limit is below the threshold":n.high>e?"probably not noticed; the upper limit is above the threshold":"not noticed, even at the upper limit"}var bl="#1c2126",Uv={ink:bl,rim:"#ffffff"};function Ov(n,e,t,i=()=>!0){n.beginPath();for(let{outline:s,places:r}of e)for(let o of r)i(o)&&pp(n,s.map(([a,l])=>[o[0]+a,o[1]+l]),t)}function Bv(n,e,t){n.save(),n.strokeStyle=Qe("carrier"),n.lineWidth=4*devicePixelRatio;for(let{hold:i,ends:s}of e)n.setLineDash(i==="clamped"?[]:[5*devicePixelRatio,3*devicePixelRatio]),n.beginPath(),pp(n,s,t),n.stroke();n.restore()}function pp(n,e,t){e.forEach((i,s)=>s===0?n.moveTo(...t(i)):n.lineTo(...t(i))),n.closePath()}function br(n,e,t){n.beginPath(),pp(n,e,t),n.stroke()}function yh([n,e],[t,i]){let[s,r]=[t/2,i/2];return[[n-s,e-r],[n+s,e-r],[n+s,e+r],[n-s,e+r]]}function xh(n,e,t,i,s=Uv){let o=t.flatMap(h=>h.map((d,p)=>[i(d),i(h[(p+1)%h.length]??d)])).filter(([h,d])=>Math.abs(h[1]-d[1])<1),a=Math.min(...o.map(([h])=>h[1])),l=([h,d])=>Math.abs(h[0]-d[0]),[c]=o.filter(([h])=>h[1]<a+1).sort((h,d)=>l(d)-l(h));if(c===void 0)return;let[u,f]=c;OC(n,e,[(u[0]+f[0])/2,a+17*devicePixelRatio],s)}function OC(n,e,[t,i],s=Uv){n.save(),n.font=`${13*devicePixelRatio}px system-ui, sans-serif`,n.textAlign="center",n.lineWidth=3*devicePixelRatio,n.strokeStyle=s.rim,n.fillStyle=s.ink;let r=n.measureText(e).width/2,o=Math.min(Math.max(t,r),n.canvas.width-r);n.strokeText(e,o,i),n.fillText(e,o,i),n.restore()}function kv({data:n,finger:e}){let t=Nt(null);fn(()=>{if(t.current!==null)return BC(t.current,n,e)},[n,e]);let{colours:i}=n.extra,s=[0,.25,.5,.75,1].map(r=>`rgb(${(i[Math.round(r*(i.length-1))]??[]).join(" ")})`);return m("div",{class:"map",children:[m("canvas",{ref:t,role:"img","aria-label":"Map of the reduction of friction"}),m("p",{class:"scale",children:[m("span",{children:"0"}),m("span",{class:"bar",style:{background:`linear-gradient(to right, ${s.join(", ")})`}}),m("span",{children:"100 %"})," less friction below a finger with its middle there, model"]})]})}function BC(n,e,t){let[i,s]=[e.columns,e.rows],r=xr.on(n,i.length,s.length);if(r===null)return()=>{};let{image:o,context:a}=r,[l,c]=[i,s].map(p=>kC(p)),u=([p,y])=>[n.width*(p-l[0])/(l[1]-l[0]),n.height*(c[1]-y)/(c[1]-c[0])],f=()=>{let{colours:p}=e.extra,[y,_]=[t.law.peek(),t.drive.peek()];s.forEach((g,b)=>i.forEach((E,S)=>{let P=e.placeIn(b,S),C=4*((s.length-1-b)*i.length+S);if(o.data[C+3]=P===null?0:255,P===null)return;let v=1-e.friction(y.value,e.amplitude(P,"value",_));(p[Math.round(Math.min(Math.max(v,0),1)*(p.length-1))]??[]).forEach((B,N)=>o.data[C+N]=B)}))},h=()=>{r.show(!1),zC(a,e,u),GC(a,e,t.place.peek(),u),n.dataset.shown=String(t.place.peek())},d=[r.follow((c[1]-c[0])/(l[1]-l[0]),h),Et(()=>{t.law.value,t.drive.value,f(),h()}),Et(()=>{t.place.value,h()}),si(h),VC(n,([p,y])=>{let _=[l[0]+p*(l[1]-l[0]),c[1]-y*(c[1]-c[0])];t.place.value=e.nearest(_)})];return()=>{for(let p of d)p()}}function kC(n){let[e=0,t=e+.001]=n,i=(t-e)/2;return[e-i,(n.at(-1)??0)+i]}function zC(n,{extra:e},t){n.lineWidth=1.2*devicePixelRatio,n.strokeStyle="#ffffff";for(let i of Object.values(e.regions).flat())br(n,i,t);n.strokeStyle=Qe("quiet");for(let i of e.plate)br(n,i,t);n.strokeStyle="#ffffff",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[i,s,r,o]of Object.values(e.patches))br(n,yh([i,s],[r,o]),t);n.setLineDash([]);for(let[i,s]of Object.entries(e.regions))xh(n,i,s,t)}function GC(n,e,t,i){let s=[e.x[t]??0,e.y[t]??0],[r,o]=i(s),a=i([s[0]+e.extra.diameter/2,s[1]])[0]-r;for(let[l,c]of[["#ffffff",5],[bl,2]])n.strokeStyle=l,n.lineWidth=c*devicePixelRatio,n.beginPath(),n.arc(r,o,a,0,2*Math.PI),n.moveTo(r-4*devicePixelRatio,o),n.lineTo(r+4*devicePixelRatio,o),n.moveTo(r,o-4*devicePixelRatio),n.lineTo(r,o+4*devicePixelRatio),n.stroke()}function VC(n,e){let t=i=>{if(i.type==="pointerdown")n.setPointerCapture(i.pointerId);else if(i.buttons===0)return;let s=n.getBoundingClientRect();e([(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height])};return n.addEventListener("pointerdown",t),n.addEventListener("pointermove",t),()=>{n.removeEventListener("pointerdown",t),n.removeEventListener("pointermove",t)}}var HC=5,zv=1.05;function Gv(n){let{drive:e,force:t,speed:i}=n.extra,s=Xe(WC(n)),r={drive:Xe(e.value),force:Xe(n.forces.indexOf(t)),speed:Xe(n.speeds.indexOf(i))};r.force.peek()<0&&(r.force.value=0);let o=xn(()=>n.law(r.force.value,r.speed.value)),a=xn(()=>qC(n,o.value,s.value,r.drive.value));return{place:s,...r,listing:Xe("none"),law:o,below:a}}function WC(n){let e=n.extra.diameter/2,t=(r,o)=>r-e>=(o[0]??0)&&r+e<=(o.at(-1)??0),[i,s]=[0,-1];for(let r=0;r<n.count;r++){let o=n.amplitude(r,"value",1),a=t(n.x[r]??0,n.columns)&&t(n.y[r]??0,n.rows);o>s&&a&&([i,s]=[r,o])}return i}function qC(n,e,t,i){let s=a=>Object.fromEntries(Nv.map(l=>[l,a(l)])),r=s(a=>n.amplitude(t,a,i)),o=s(a=>n.friction(e[a],r[a]));return{amplitude:r,free:n.amplitude(t,"free",i),friction:o,reduction:{value:1-o.value,low:1-o.high,high:1-o.low}}}function Vv(n,e){let t=(c,u)=>f=>{for(let h=0;h<(f.shiftKey?HC:1);h++)e.place.value=n.beside(e.place.peek(),c,u)},{low:i,high:s}=n.extra.drive,r=c=>()=>e.drive.value=Math.min(Math.max(e.drive.peek()*c,i),s),o=(c,u,f)=>()=>c.value=Math.min(Math.max(c.peek()+u,0),f-1),[a,l]=[n.forces.length,n.speeds.length];return[{keys:"← → ↑ ↓",effect:"move the finger; five places with Shift",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}},{keys:"+ −",effect:"5 % more or less drive",actions:{"+":r(zv),"-":r(1/zv)}},{keys:"f F",effect:"more or less force",actions:{f:o(e.force,1,a),F:o(e.force,-1,a)}},{keys:"s S",effect:"faster or slower",actions:{s:o(e.speed,1,l),S:o(e.speed,-1,l)}},...ni(e.listing)]}function Hv({plate:n,choice:e}){let t=Nt(null);return fn(()=>{if(t.current!==null)return YC([...t.current.querySelectorAll("canvas")],n,e)},[n,e]),m("div",{class:n.fields.length>1?"maps":"",ref:t,children:n.fields.map(i=>m(XC,{plate:n,choice:e,field:i},i.title))})}function XC({plate:n,choice:e,field:t}){let i=Nt(null),r=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(l=>`rgb(${(n.colours[l]??[]).join(" ")})`),o=Kr(Wv(n,e,t,e.line.value)),a=t.title||Vi(n.data);return m("div",{class:"map",children:[t.title&&m("h2",{children:t.title}),m("canvas",{ref:i,role:"img","aria-label":`Map of the moving plate${t.title&&`, ${t.title}`}`}),m("p",{class:"scale",children:[m("span",{children:`−${o}`}),m("span",{class:"bar",style:{background:`linear-gradient(to right, ${r.join(", ")})`}}),m("span",{children:o})," normal displacement",n.drive]}),m(Ro,{canvas:i,name:"map",caption:`${n.data.header.title}, ${a}`})]})}function Wv(n,e,t,i){return n.largest(i,e.common.value?n.fields:[t])}function Kr(n){let[e,t]=n>=1e-6?["µm",1e6]:n>=1e-9?["nm",1e9]:["pm",1e12];return`${Number((n*Number(t)).toPrecision(3))} ${e}`}function YC(n,e,t){let{left:i,right:s,bottom:r,top:o}=e.extent,a=e.fields.flatMap((h,d)=>{let p=n[d],y=p===void 0?null:xr.on(p,h.columns,h.rows);return p===void 0||y===null?[]:[{field:h,canvas:p,raster:y,counted:{frames:0}}]}),l=()=>{for(let h of a)c(h)},c=({field:h,canvas:d,raster:p,counted:y})=>{let _=t.line.peek();y.frames++;let g=(e.fields[0]??h).outermost(_)+u.moment;h.paint(p.image,_,g,Wv(e,t,h,_)),p.show(!e.data.has("place"));let b=([E,S])=>[d.width*(E-i)/(s-i),d.height*(o-S)/(o-r)];$C(p.context,e,b,t.plan.peek()),d.dataset.shown=String(_)},u=new ir(t,l,...n);for(let{canvas:h,counted:d}of a)Co(h,p=>u.at(p)),Object.assign(h,{counted:d});let f=[...a.map(({raster:h})=>h.follow((o-r)/(s-i),l)),Et(()=>{t.line.value,t.plan.value,t.common.value,l()}),si(l)];return()=>{u.end();for(let h of f)h()}}function $C(n,e,t,i){let{plate:s,regions:r,patches:o,features:a,held:l}=e.parts;n.strokeStyle=bl,n.lineWidth=1.2*devicePixelRatio;for(let c of Object.values(r).flat())br(n,c,t);i&&(n.lineWidth=.8*devicePixelRatio,Ov(n,a,t),n.stroke(),Bv(n,l,t)),n.lineWidth=1.2*devicePixelRatio,n.strokeStyle=Qe("quiet");for(let c of s)br(n,c,t);n.strokeStyle="#855a12",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[c,u,f,h]of Object.values(o))br(n,yh([c,u],[f,h]),t);n.setLineDash([]);for(let[c,u]of Object.entries(r))xh(n,c,u,t)}var ZC="All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, at the nearest computed place.",KC=500;function Yv(n){return m(JC,{dataset:n})}function JC({dataset:n}){let e=Ge(()=>new vh(n),[n]),t=Ge(()=>Gv(e),[e]),i=Ge(()=>Vv(e,t),[e,t]);return m(Jn,{name:"finger",data:n,keys:i,foot:ZC,children:[m("div",{class:"pair",children:[m("section",{"aria-label":"Map",children:m(Vn,{label:"Finger on the plate. Arrow keys move it.",describedBy:"felt",children:m(kv,{data:e,finger:t})})}),m("section",{"aria-label":"Friction",children:[m(jC,{data:e,finger:t}),m(Dv,{data:e,finger:t}),m(QC,{data:e,finger:t})]})]}),m(ii,{listing:t.listing,keys:i,children:m(eR,{data:e})})]})}function zs(n,e){let t=Math.abs(n),[i,s]=t>=1||t===0?["",1]:t>=.001?["m",1e3]:["µ",1e6];return`${Number((n*Number(s)).toPrecision(3))} ${i}${e}`}var qv=n=>`${(100*n).toFixed(0)} %`;function jC({data:n,finger:e}){let{amplitude:t,free:i,friction:s,reduction:r}=e.below.value,o=e.place.value,{weber:a,frequency:l,drive:c,diameter:u}=n.extra,f=(d,p,[y,_])=>`${p(d.value)} (${p(d[y])} to ${p(d[_])})`,h=d=>d.toFixed(2);return m("div",{class:"facts",children:[m("p",{id:"felt","aria-live":"polite",children:[m("b",{children:n.region(o)}),", x = ",zs(n.x[o]??0,"m"),", y = ",zs(n.y[o]??0,"m"),":"," ",m("b",{children:Fv(r,a)})]}),m(Ii,{facts:[["mu / mu0, model",f(s,h,["low","high"])],["less friction",f(r,qv,["low","high"])],["amplitude below the finger",f(t,Kr,["high","low"])],["without a finger",Kr(i)]]}),m("p",{class:"again",children:["People notice reductions above ",qv(a),". The finger covers ",zs(u,"m"),";"," ",Number((l/1e3).toFixed(3))," kHz. The same in the study:"," ",m("code",{children:["touch = ","{",' force = "',zs(n.forces[e.force.value]??0,"N"),'", speed = "',zs(n.speeds[e.speed.value]??0,"m/s"),'"',c.unit==="V"?`, voltage = "${zs(e.drive.value,"V")}"`:""," ","}"]})]})]})}function QC({data:n,finger:e}){let{low:t,high:i,title:s,unit:r}=n.extra.drive;return m("div",{class:"controls",children:[m("label",{class:"long",children:["Drive, ",s.toLowerCase(),": ",zs(e.drive.value,r),m("input",{type:"range",min:t,max:i,step:(i-t)/KC||1,value:e.drive.value,"aria-valuetext":zs(e.drive.value,r),onInput:o=>e.drive.value=Number(o.currentTarget.value)})]}),m(Xv,{title:n.data.title("force"),unit:"N",values:n.forces,chosen:e.force}),m(Xv,{title:n.data.title("speed"),unit:"m/s",values:n.speeds,chosen:e.speed})]})}function Xv({title:n,unit:e,values:t,chosen:i}){let s=zs(t[i.value]??0,e);return m("label",{class:"long",children:[n,": ",s,m("input",{type:"range",min:"0",max:t.length-1,step:"1",value:i.value,"aria-valuetext":s,onInput:r=>i.value=Number(r.currentTarget.value)})]})}function eR({data:n}){return m("div",{class:"wide",children:[m("table",{children:[m("caption",{children:"Numbers of the models"}),m("thead",{children:m("tr",{children:["number","value","plausible","origin","source"].map(e=>m("th",{scope:"col",children:e}))})}),m("tbody",{children:n.extra.parameters.map(({title:e,value:t,plausible:i,mark:s,source:r})=>m("tr",{children:[e,t,i,s,r].map(o=>m("td",{children:o}))}))})]}),m("dl",{children:Object.entries(n.extra.models).map(([e,t])=>m("div",{children:[m("dt",{children:["Model of ",e]}),m("dd",{children:t})]}))})]})}var tR="Squares are all participants together, discs are single ones; circles are trials.",[bh,mp,nR,iR]=[24,8,36,16],sR=7.2,$v=300;function Zv(n){return m(rR,{data:n})}function rR({data:n}){let e=Ge(()=>cR(n),[n]),t=Ge(()=>[...new Set(e.map(({quantity:l})=>l))],[e]),i=Ge(()=>({quantity:Xe(t[0]??""),row:Xe(0),listing:Xe("none")}),[t]),s=Ge(()=>uR(e,t,i),[e,t,i]),r=e.filter(({quantity:l})=>l===i.quantity.value),o=r[i.row.value],a=n.header.extra.sentences??[];return m(Jn,{name:"friction",data:n,keys:s,foot:tR,children:[a.length>0&&m("details",{children:[m("summary",{children:"Estimates, tests and assumptions"}),a.map(l=>m("p",{children:l}))]}),m("p",{class:"axes",children:m("label",{children:["Quantity"," ",m("select",{value:i.quantity.value,onChange:l=>{i.quantity.value=l.currentTarget.value,i.row.value=0},children:t.map(l=>m("option",{children:l}))})]})}),m(Vn,{label:"Estimates. Arrow keys go from one to the next.",children:m(oR,{estimates:r,choice:i})}),m("div",{class:"facts",children:m("p",{id:"point","aria-live":"polite",children:o!==void 0&&m(ln,{children:[m("b",{children:o.name}),": ",lR(o),o.note&&`; ${o.note}`]})})}),m(ii,{listing:i.listing,keys:s,children:t.map(l=>m(aR,{title:l,estimates:e.filter(c=>c.quantity===l)}))})]})}function oR({estimates:n,choice:e}){let[t,i]=fR(),s=Math.min(sR*Math.max(...n.map(({name:u})=>u.length),4)+12,.5*i),r=n.flatMap(({value:u,low:f,high:h,trials:d})=>[u,f,h,...d]).filter(Number.isFinite),[o,a]=[Math.min(0,...r),Math.max(...r,.01)],l=u=>s+(u-o)/(a-o)*(i-s-iR),c=mp+bh*n.length;return m("div",{ref:t,children:m("svg",{class:"estimates",width:i,height:c+nR,role:"img","aria-label":`${e.quantity.value}; the table has all numbers`,children:[hR(o,a).map(u=>m(ln,{children:[m("line",{x1:l(u),x2:l(u),y1:mp,y2:c}),m("text",{x:l(u),y:c+16,"text-anchor":"middle",class:"quiet",children:`${u}`.replace("-","−")})]})),m("text",{x:(s+i)/2,y:c+32,"text-anchor":"middle",children:e.quantity.value}),n.map((u,f)=>{let h=mp+bh*(f+.5),{value:d,low:p,high:y,name:_,whole:g,trials:b}=u;return m("g",{class:g?"whole":"",onClick:()=>e.row.value=f,children:[m("rect",{class:e.row.value===f?"chosen":"",x:"1",y:h-bh/2,width:i-2,height:bh,fill:"transparent"}),m("text",{x:s-8,y:h+4,"text-anchor":"end",children:_}),b.map(E=>m("circle",{class:"trial",cx:l(E),cy:h,r:"2.5"})),Number.isFinite(p)&&m("line",{class:"interval",x1:l(p),x2:l(y),y1:h,y2:h}),Number.isFinite(d)&&(g?m("rect",{class:"mark",x:l(d)-5,y:h-5,width:"10",height:"10"}):m("circle",{cx:l(d),cy:h,r:"4.5"}))]})})]})})}function aR({title:n,estimates:e}){return m("div",{class:"wide",tabIndex:0,role:"group","aria-label":n,children:m("table",{children:[m("caption",{children:n}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"of"}),m("th",{scope:"col",children:"value"}),m("th",{scope:"col",children:"from"}),m("th",{scope:"col",children:"to"}),m("th",{scope:"col",children:"note"})]})}),m("tbody",{children:e.map(({name:t,value:i,low:s,high:r,note:o})=>m("tr",{children:[m("td",{children:t}),m("td",{children:la(i)}),m("td",{children:la(s)}),m("td",{children:la(r)}),m("td",{children:o})]}))})]})})}var la=n=>Number.isFinite(n)?n.toFixed(3).replace("-","−"):"-",lR=({value:n,low:e,high:t})=>la(n)+(Number.isFinite(e)?`, from ${la(e)} to ${la(t)}`:"");function cR(n){let[e,t,i]=["quantity","name","note"].map(c=>n.texts(c)),[s,r,o]=["low","high","whole"].map(c=>n.values(c)),a=n.texts("trial_condition"),l=new Map;return n.values("trial_friction").forEach((c,u)=>{let f=a[u]??"";l.set(f,[...l.get(f)??[],c])}),Array.from(n.values("value"),(c,u)=>({quantity:e?.[u]??"",name:t?.[u]??"",note:i?.[u]??"",value:c,low:s?.[u]??NaN,high:r?.[u]??NaN,whole:o?.[u]===1,trials:(l.get(t?.[u]??"")??[]).filter(Number.isFinite)}))}function uR(n,e,t){let i=()=>n.filter(({quantity:o})=>o===t.quantity.peek()).length-1,s=o=>()=>t.row.value=Math.min(Math.max(t.row.peek()+o,0),i()),r=()=>{let o=e.indexOf(t.quantity.peek());t.quantity.value=e[(o+1)%e.length]??"",t.row.value=0};return[{keys:"↑ ↓",effect:"previous or next estimate",actions:{ArrowUp:s(-1),ArrowDown:s(1)}},{keys:"q",effect:"next quantity",actions:{q:r}},...ni(t.listing)]}function hR(n,e){let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5,10].find(a=>a*i>=t)??10),r=Math.ceil(n/s-1e-9),o=Math.floor(e/s+1e-9)-r+1;return Array.from({length:o},(a,l)=>Number(((r+l)*s).toPrecision(6)))}function fR(){let n=Nt(null),[e,t]=Zs($v);return fn(()=>{let i=n.current;if(i===null)return;let s=new ResizeObserver(()=>t(Math.min(Math.max(i.clientWidth,$v),960)));return s.observe(i),()=>s.disconnect()},[]),[n,e]}var dR=6,pR=2,mR=["across the rows","along the rows","normal to the plate"],Sh=class{constructor(e){this.data=e;this.frequency=e.values("frequency"),this.rows=e.values("rows"),this.kinds=e.texts("incident"),this.incident=this.kinds.filter(t=>this.losses(t).flat().some(Number.isFinite)),[this.waves=0]=e.shape("decay"),this.carrier=Number(e.header.extra.carrier),this.gap=e.header.extra.gap,this.units=Ci(e)}data;frequency;rows;incident;waves;carrier;gap;units;kinds;nearest(e){let t=Array.from(this.frequency,i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}losses(e,t="loss"){let i=this.kinds.indexOf(e)*this.rows.length;return Array.from(this.rows,(s,r)=>this.curve(t,i+r))}ofWaves(e){return Array.from({length:this.waves},(t,i)=>this.curve(e,i))}get hasFields(){return this.data.has("wave_real")}get fields(){let{data:e}=this,[,,t=0,i=0]=e.shape("wave_real"),[s,r]=[Kv(e.values("across")),Kv(e.values("along"))],o={real:e.values("wave_real"),imag:e.values("wave_imag"),present:e.values("present")},a=e.header.extra.colours,l=e.values("slab_slip")[0]??0;return{grid:{...o,across:t,along:i,width:s*t,length:r*i,colours:a},part:{periods:Math.ceil(dR/(e.values("slab_rows")[0]??1)),repeats:pR,slip:l}}}field(e,t){let i=e*this.frequency.length+t;return{number:i,phase:this.data.values("slab_phase")[i]??0,decay:this.data.values("slab_decay")[i]??0}}direction(e,t){return mR[this.data.values("wave_component")[e*this.frequency.length+t]??2]??""}curve(e,t){let i=this.frequency.length;return Array.from(this.data.values(e).subarray(t*i,(t+1)*i))}};function Mh(n){return n.map(e=>Number.isFinite(e)?e:null)}function Kv(n){return(n[1]??0)-(n[0]??0)}var gR="Errors are the change of a value if all frequencies of the lattice move by the bound of their relative error, and this share of the value. Waves of the lattice are shown at normal incidence. The field is that of the strongest component on the flat face, over six rows; a wave enters them from the left, relative to its largest displacement in the first row.",_R=10,jv=1.05,vR=60,yR="Fields of the waves are computed with the option --html.";function Qv(n){return m(xR,{data:n})}function xR({data:n}){let e=Ge(()=>new Sh(n),[n]),t=Ge(()=>({line:Xe(e.nearest(e.carrier)),rows:Xe(e.rows.length-1),incident:Xe(e.incident[0]??""),wave:Xe(0),...hs(),unit:Xe(Ri(e.units,Math.max(...e.frequency))),listing:Xe("none")}),[e]),i=Ge(()=>bR(e,t),[e,t]);return m(Jn,{name:"mirror",data:n,keys:i,foot:gR,children:[m("div",{class:"pair",children:[m("section",{"aria-label":"Insertion loss",children:[m(Vn,{label:"Insertion loss. Arrow keys change the frequency and the number of rows.",children:m(SR,{mirror:e,choice:t})}),m("p",{class:"axes",children:[m("label",{children:["Incident wave"," ",m("select",{value:t.incident.value,onChange:s=>t.incident.value=s.currentTarget.value,children:e.incident.map(s=>m("option",{children:s}))})]}),m(Pi,{title:"Frequencies in",units:e.units,unit:t.unit}),m("span",{class:"legend",children:[e.gap&&m("span",{class:"of-gap",children:"gap"}),m("span",{class:"of-carrier",children:"carrier"})]})]}),m(AR,{mirror:e,choice:t}),m(MR,{mirror:e,choice:t})]}),m("section",{"aria-label":"Waves of the lattice",children:[m(Jv,{mirror:e,choice:t,name:"decay"}),m(ER,{mirror:e,choice:t}),e.hasFields?m(TR,{mirror:e,choice:t}):m("p",{children:yR}),m(Jv,{mirror:e,choice:t,name:"phase"})]})]}),m(ii,{listing:t.listing,keys:i,children:[m(CR,{mirror:e,choice:t}),m(RR,{mirror:e,choice:t})]})]})}function bR(n,e){let t=(o,a)=>Math.min(Math.max(o,0),a-1),i=o=>e.line.value=t(e.line.value+o,n.frequency.length),s=o=>e.rows.value=t(e.rows.value+o,n.rows.length),r=o=>o.shiftKey?_R:1;return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:o=>i(-r(o)),ArrowRight:o=>i(r(o))}},{keys:"↑ ↓",effect:"one more or one less row",actions:{ArrowUp:()=>s(1),ArrowDown:()=>s(-1)}},{keys:"i",effect:"next incident wave",actions:{i:()=>{let o=(n.incident.indexOf(e.incident.value)+1)%n.incident.length;e.incident.value=n.incident[o]??""}}},{keys:"w W",effect:"wave of the lattice with the next higher or lower decay",actions:{w:()=>e.wave.value=t(e.wave.value+1,n.waves),W:()=>e.wave.value=t(e.wave.value-1,n.waves)}},cs(e),{keys:"c",effect:"carrier",actions:{c:()=>e.line.value=n.nearest(n.carrier)}},...ni(e.listing)]}function ey({mirror:n,choice:e}){let{factor:t}=e.unit.value,i=(n.frequency[e.line.value]??0)/t;return{below:s=>{n.gap&&Fr(s,[n.gap[0]/t,n.gap[1]/t],"gap")},above:s=>{js(s,n.carrier/t,"carrier",[7,5]),js(s,i,"accent")},pick:s=>e.line.value=n.nearest(s*t)}}function ty({mirror:n,choice:e}){let{factor:t}=e.unit.value;return Ge(()=>Array.from(n.frequency,i=>i/t),[n,t])}function SR({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.rows.value],s=Ge(()=>n.losses(t).map((r,o)=>({values:Mh(r),colour:o===i?"accent":"quiet",width:o===i?2.6:1})),[n,t,i]);return m(es,{x:ty({mirror:n,choice:e}),curves:s,titles:[Xt("frequency",e.unit.value),`${n.data.title("loss")} / dB`],height:300,...ey({mirror:n,choice:e})})}function MR({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.line.value],[s,r]=["loss","loss_error"].map(c=>n.losses(t,c).map(u=>u[i]??NaN)),o=Ge(()=>Array.from(n.rows),[n]),a=Ge(()=>[{values:Mh(s??[]),colour:"quiet",dash:[2,4]}],[n,t,i]),l=Math.max(1,...o.map((c,u)=>(s?.[u]??NaN)+(r?.[u]??NaN)).filter(Number.isFinite));return m(es,{x:o,curves:a,titles:["rows",`${n.data.title("loss")} / dB`],height:200,whole:!0,limits:{x:[.5,o.length+.5],y:[Math.min(0,...(s??[]).filter(Number.isFinite)),jv*l]},above:c=>o.forEach((u,f)=>{let[h=NaN,d=NaN]=[s?.[f],r?.[f]];if(!Number.isFinite(h))return;let p=y=>[c.valToPos(u,"x",!0),c.valToPos(y,"y",!0)];Qs(c.ctx,p(h-d),p(h+d),"ink"),As(c.ctx,p(h),f===e.rows.value?"accent":"quiet")}),pick:c=>e.rows.value=Math.min(Math.max(Math.round(c)-1,0),o.length-1)},`${t} ${i}`)}function Jv({mirror:n,choice:e,name:t}){let i=Ge(()=>n.ofWaves(t).map(l=>({values:Mh(l),colour:"curve-0",points:!0})),[n,t]),s=e.line.value,r=i[e.wave.value]?.values[s],o=ey({mirror:n,choice:e}),a=Math.min(vR,jv*Math.max(...i.flatMap(({values:l})=>l.map(c=>c??0))));return m(es,{x:ty({mirror:n,choice:e}),curves:i,titles:[Xt("frequency",e.unit.value),`${n.data.title(t)} / ${t==="decay"?"(dB/row)":"π"}`],height:t==="decay"?300:200,limits:{y:t==="decay"?[0,a]:[0,1]},below:o.below,above:l=>{o.above(l),typeof r=="number"&&As(l.ctx,[l.valToPos((n.frequency[s]??0)/e.unit.value.factor,"x",!0),l.valToPos(r,"y",!0)],"accent")},pick:(l,c)=>{o.pick(l),e.wave.value=wR(i.map(({values:u})=>u[e.line.value]??NaN),c)??e.wave.value}})}function wR(n,e){return n.map((i,s)=>s).filter(i=>Number.isFinite(n[i])).sort((i,s)=>Math.abs(n[i]-e)-Math.abs(n[s]-e))[0]}function TR({mirror:n,choice:e}){let{grid:t,part:i}=Ge(()=>n.fields,[n]),s=Ge(()=>xn(()=>n.field(e.wave.value,e.line.value)),[n,e]),r=`${n.data.header.title}, ${Vi(n.data)}`;return m(ln,{children:[m(aa,{grid:t,part:i,wave:s,pace:e,label:"Field of the wave, rows from left to right",name:"wave",caption:r}),m(po,{...e})]})}function ER({mirror:n,choice:e}){let[t,i]=[e.wave.value,e.line.value],s=c=>n.ofWaves(c)[t]?.[i]??NaN,[r,o]=[s("decay"),s("phase")],a=Number.isFinite(o),l=[["decay",`${Gt(r,s("decay_error"))} dB per row`],["phase",a?`${Gt(o,s("phase_error"))} π per row`:""],["shown displacement",n.hasFields?n.direction(t,i):""]];return m("div",{class:"facts",children:[m("p",{id:"wave","aria-live":"polite",children:["Wave ",t+1," of ",n.waves," in the lattice at ",m("b",{children:wh({mirror:n,choice:e})}),":"," ",m("b",{children:a?"propagates":"decays"})]}),m(Ii,{facts:l})]})}function wh({mirror:n,choice:e}){let t=e.unit.value;return kn(ls((n.frequency[e.line.value]??0)/t.factor),t)}function ny(n,e){return Number.isFinite(n)?`${Gt(n??NaN,e??NaN)} dB`:"does not propagate"}function AR({mirror:n,choice:e}){let[t,i,s]=[e.incident.value,e.line.value,e.rows.value],[r,o]=["loss","loss_error"].map(l=>n.losses(t,l)[s]?.[i]),a=n.rows[s]??0;return m("div",{class:"facts",children:[m("p",{id:"point","aria-live":"polite",children:[t," at ",m("b",{children:wh({mirror:n,choice:e})}),", ",a," row",a===1?"":"s",": ",m("b",{children:ny(r,o)})]}),m("p",{class:"again",children:["The same as a picture, in Python: ",m("code",{children:['study.layers().plot("layers", incident="',t,'")']})]})]})}function CR({mirror:n,choice:e}){let t=e.line.value;return m("div",{class:"wide",children:m("table",{children:[m("caption",{children:["Insertion loss at ",wh({mirror:n,choice:e})]}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"rows"}),n.incident.map(i=>m("th",{scope:"col",children:["incident ",i]}))]})}),m("tbody",{children:Array.from(n.rows,(i,s)=>m("tr",{"aria-current":s===e.rows.value?"true":void 0,children:[m("td",{children:i}),n.incident.map(r=>m("td",{children:ny(n.losses(r)[s]?.[t],n.losses(r,"loss_error")[s]?.[t])}))]}))})]})})}function RR({mirror:n,choice:e}){let t=e.line.value,i=["decay","decay_error","phase","phase_error"].map(s=>n.ofWaves(s));return m("div",{class:"wide",children:m("table",{children:[m("caption",{children:["Waves of the lattice at ",wh({mirror:n,choice:e})]}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"decay / (dB/row)"}),m("th",{scope:"col",children:"phase per row / π"}),m("th",{scope:"col",children:"show"})]})}),m("tbody",{children:Array.from({length:n.waves},(s,r)=>{let[o=NaN,a=NaN,l=NaN,c=NaN]=i.map(u=>u[r]?.[t]);return m("tr",{"aria-current":r===e.wave.value?"true":void 0,children:[m("td",{children:Gt(o,a)}),m("td",{children:Number.isFinite(l)?Gt(l,c):"decays"}),m("td",{children:m("button",{type:"button",onClick:()=>e.wave.value=r,children:["wave ",r+1]})})]})})})]})})}var gp=class{constructor(e,t,i,s,r,o,a){this.title=i;this.columns=s;this.rows=r;this.places=o;this.colours=a;this.real=e.values(`${t}_real`),this.imag=e.values(`${t}_imag`),this.step=e.values(`${t}_step`),this.count=e.shape(`${t}_real`).slice(1).reduce((l,c)=>l*c,1),this.largestStep=(a.length-1)/2}title;columns;rows;places;colours;largestStep;real;imag;step;count;largest(e){return(this.step[e]??0)*this.largestStep}paint(e,t,i,s){let r=s>0?this.largest(t)/s:0,[o,a]=[r*Math.cos(2*Math.PI*i),r*Math.sin(2*Math.PI*i)],l=this.largestStep,c=t*this.count;for(let u=0;u<this.rows;u++)for(let f=0;f<this.columns;f++){let h=this.places[u*this.columns+f]??-1,d=(this.real[c+h]??0)*o-(this.imag[c+h]??0)*a,p=Math.min(Math.max(Math.round(l+d),0),2*l),[y=0,_=0,g=0]=this.colours[p]??[],b=4*((this.rows-1-u)*this.columns+f);e.data[b]=y,e.data[b+1]=_,e.data[b+2]=g,e.data[b+3]=h<0?0:255}}outermost(e){let t=e*this.count,[i,s]=[0,-1];for(let r=t;r<t+this.count;r++){let o=Math.hypot(this.real[r]??0,this.imag[r]??0);o>s&&([i,s]=[r,o])}return-Math.atan2(this.imag[i]??0,this.real[i]??0)/(2*Math.PI)}},Th=class{constructor(e){this.data=e;let{extra:t}=e.header;this.frequency=e.values("frequency"),this.gap=t.gap,this.carrier=t.carrier,this.drive=String(t.drive),this.firstIs=String(t.first_is),this.python=String(t.python),this.parts=t,this.colours=t.colours,this.units=Ci(e);let i=PR(e),[s=0,r=0]=e.shape(e.has("place")?"place":"present");this.fields=Object.entries(t.maps).map(([c,u])=>new gp(e,c,u,r,s,i,this.colours));let o=e.has("mode_frequency"),[a,l]=o?[e.values("mode_frequency"),e.values("mode_quality")]:[[],[]];this.modes=Array.from(a,(c,u)=>({frequency:c,name:e.texts("mode_name")[u]??"",quality:l[u]??NaN}))}data;frequency;fields;gap;carrier;drive;firstIs;python;parts;modes;colours;units;nearest(e){let t=0;return this.frequency.forEach((i,s)=>{Math.abs(i-e)<Math.abs((this.frequency[t]??0)-e)&&(t=s)}),t}get first(){return this.nearest(Number(this.data.header.extra.first))}largest(e,t=this.fields){return Math.max(...t.map(i=>i.largest(e)))}get extent(){let[e,t]=[this.data.values("x"),this.data.values("y")],[i,s]=[iy(e),iy(t)];return{left:(e[0]??0)-i,right:(e[e.length-1]??0)+i,bottom:(t[0]??0)-s,top:(t[t.length-1]??0)+s}}has(e){return this.data.has(e)}curves(e){if(!this.data.has(e))return[];let t=this.data.values(e),i=this.data.texts(e==="level"?"region":"pair"),s=this.frequency.length;return i.map((r,o)=>({name:r,values:Array.from(t.subarray(o*s,(o+1)*s),a=>Number.isFinite(a)&&(e==="contrast"||a>0)?a:null)}))}};function PR(n){return n.has("place")?Int32Array.from(n.values("place")):Int32Array.from(n.values("present"),(e,t)=>e===0?-1:t)}function iy(n){return n.length>1?.5*((n[1]??0)-(n[0]??0)):5e-4}var Sl=[[],[8,4],[2,3],[10,3,2,3]],_p=4,IR=300;function sy({plate:n,choice:e}){let t=Nt(null),i=e.shown.value;return Gi(()=>{if(t.current!==null)return LR(t.current,n,e)},[n,e,i]),m("div",{class:"curves",ref:t})}function LR(n,e,t){let i=t.shown.peek(),s=e.curves(i),r=e.data.unit(i),o={stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")}},a={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},l=()=>t.unit.peek().factor,c=()=>[Array.from(e.frequency,h=>h/l()),...s.map(({values:h})=>h)],u=()=>({width:er(n),height:IR}),f=new Qt({...u(),legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},scales:{x:{time:!1},y:{distr:i==="level"?3:1}},axes:[{...o,...a,label:"frequency",labelSize:22,size:34,grid:{show:!1}},{...o,...a,label:`${e.data.title(i)} / ${r}`,labelSize:24,size:58,grid:{show:!1},values:(h,d)=>d.map(p=>p===null?"":DR(p,i==="level"))}],series:[{},...s.map((h,d)=>({stroke:()=>Qe(`curve-${d%_p}`),dash:Sl[d%Sl.length]??[],width:1.4,points:{show:!1}}))],hooks:{drawClear:[h=>nr(h,()=>NR(h,e,l()))],draw:[h=>FR(h,e,t)]}},c(),n);return Eo(f,h=>t.line.value=e.nearest(l()*f.posToVal(h,"x"))),tr(f,n,u,[Et(()=>{let h=f.axes[0];h!==void 0&&(h.label=Xt("frequency",t.unit.value)),f.setData(c(),!0)}),Et(()=>{t.line.value,f.redraw(!1,!1)})])}function DR(n,e){if(!e)return`${Number(n.toPrecision(4))}`.replace("-","−");let t=Math.log10(n);return Math.abs(t-Math.round(t))<1e-9?`1e${Math.round(t)}`.replace("-","−"):""}function NR(n,e,t){e.gap!==null&&Fr(n,[e.gap[0]/t,e.gap[1]/t],"gap")}function FR(n,e,t){let{factor:i}=t.unit.peek();e.carrier!==null&&js(n,e.carrier/i,"carrier",[7,5]),js(n,(e.frequency[t.line.peek()]??0)/i,"accent")}var UR=10;function ry(n){return{line:Xe(n.first),shown:Xe(n.has("level")?"level":"contrast"),plan:Xe(!1),common:Xe(!1),unit:Xe(Ri(n.units,Math.max(...n.frequency))),...hs(),listing:Xe("none")}}function oy(n,e){let t=n.frequency.length-1,i=u=>e.line.value=Math.min(Math.max(e.line.value+u,0),t),s=u=>u.shiftKey?UR:1,r=n.modes.map(({frequency:u})=>n.nearest(u)).sort((u,f)=>u-f),o=u=>{u!==void 0&&(e.line.value=u)},{carrier:a}=n,l={keys:"p n",effect:"previous or next mode near the carrier",actions:{p:()=>o(r.filter(u=>u<e.line.value).pop()),n:()=>o(r.find(u=>u>e.line.value))}},c={keys:"s",effect:"one scale of colours for both maps, or one for each",actions:{s:()=>e.common.value=!e.common.value}};return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:u=>i(-s(u)),ArrowRight:u=>i(s(u))}},...r.length>0?[l]:[],...a!==null?[{keys:"c",effect:"carrier",actions:{c:()=>o(n.nearest(a))}}]:[],{keys:"g",effect:n.firstIs,actions:{g:()=>o(n.first)}},...n.fields.length>1?[c]:[],{keys:"l",effect:"pillars and supports",actions:{l:()=>e.plan.value=!e.plan.value}},cs(e),...ni(e.listing)]}var OR="The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.",BR="Each point of the scan is a square of the map. Measurement and model move with the phase of the drive.",ay=["level","contrast"];function ly(n){return m(uy,{data:n,foot:OR})}function cy(n){return m(uy,{data:n,foot:BR})}function uy({data:n,foot:e}){let t=Ge(()=>new Th(n),[n]),i=Ge(()=>ry(t),[t]),s=Ge(()=>oy(t,i),[t,i]),r=ay.filter(o=>t.has(o));return m(Jn,{name:"plate",data:n,keys:s,foot:e,children:[m("div",{class:t.fields.length>1?"":"pair",children:[m("section",{"aria-label":"Spectra",children:[r.length>0&&t.frequency.length>1&&m(ln,{children:[m(Vn,{label:"Spectra. Arrow keys change the frequency.",children:m(sy,{plate:t,choice:i})}),m(kR,{plate:t,choice:i}),m("p",{class:"axes",children:[m("label",{children:["Curves"," ",m("select",{value:i.shown.value,onChange:o=>i.shown.value=o.currentTarget.value,children:r.map(o=>m("option",{value:o,children:t.data.title(o)}))})]}),m(Pi,{title:"Frequencies in",units:t.units,unit:i.unit})]})]}),m(zR,{plate:t,choice:i})]}),m("section",{"aria-label":"Map",children:[m(Hv,{plate:t,choice:i}),m("div",{class:"controls",children:[m(Cr,{playing:i.playing}),m(GR,{plate:t,choice:i}),m(Ca,{pace:i.pace}),m("label",{class:"check",children:[m("input",{type:"checkbox",checked:i.plan.value,onChange:o=>i.plan.value=o.currentTarget.checked}),"pillars and supports"]}),t.fields.length>1&&m("label",{class:"check",children:[m("input",{type:"checkbox",checked:i.common.value,onChange:o=>i.common.value=o.currentTarget.checked}),"one scale of colours for both maps"]})]})]})]}),m(ii,{listing:i.listing,keys:s,children:[m(VR,{plate:t,choice:i}),m(HR,{plate:t,choice:i})]})]})}function kR({plate:n,choice:e}){return m("p",{class:"legend",children:[n.curves(e.shown.value).map(({name:t},i)=>m("span",{class:"of-curve",children:[m("svg",{width:"34",height:"8","aria-hidden":"true",children:m("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${i%_p})`,"stroke-dasharray":(Sl[i%Sl.length]??[]).join(" ")})})," ",t]})),n.gap!==null&&m("span",{class:"of-gap",children:"gap"}),n.carrier!==null&&m("span",{class:"of-carrier",children:"carrier"})]})}function ca(n,e){return kn(ls(n/e.factor),e)}function zR({plate:n,choice:e}){let t=e.line.value,i=n.frequency[t]??0,s=n.curves("contrast");return m("div",{class:"facts",children:[m("p",{id:"point","aria-live":"polite",children:[m("b",{children:ca(i,e.unit.value)}),": up to ",Kr(n.largest(t)),n.drive,s.map(({name:r,values:o})=>`; ${r} ${o[t]?.toFixed(1)??"-"} dB`).join("")]}),m("p",{class:"again",children:["The same map as a picture, in Python: ",m("code",{children:`${n.python}.plot("maps", frequency=${Number(i.toFixed(3))})`})]})]})}function GR({plate:n,choice:e}){let t=n.frequency.length-1,i=e.line.value;return m("label",{class:"long",children:["frequency: ",ca(n.frequency[i]??0,e.unit.value),m("input",{type:"range",min:"0",max:t,step:"1",value:i,disabled:t===0,"aria-valuetext":ca(n.frequency[i]??0,e.unit.value),onInput:s=>e.line.value=Number(s.currentTarget.value)})]})}function VR({plate:n,choice:e}){let t=e.line.value,i=ay.flatMap(s=>n.curves(s).map(({name:r,values:o})=>[n.data.title(s),r,`${o[t]?.toPrecision(3)??"-"} ${n.data.unit(s)}`]));for(let s of n.fields.length>1?n.fields:[])i.push(["largest displacement",s.title,`${Kr(s.largest(t))}${n.drive}`]);return n.data.has("agreement")&&i.push([n.data.title("agreement"),"both maps",(n.data.values("agreement")[t]??0).toFixed(3)]),m("div",{class:"wide",children:m("table",{children:[m("caption",{children:["Regions at ",ca(n.frequency[t]??0,e.unit.value)]}),m("tbody",{children:i.map(s=>m("tr",{children:s.map(r=>m("td",{children:r}))}))})]})})}function HR({plate:n,choice:e}){return n.modes.length===0?null:m("div",{class:"wide",children:m("table",{children:[m("caption",{children:"Modes near the carrier"}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"frequency"}),m("th",{scope:"col",children:"nodal lines"}),m("th",{scope:"col",children:"Q"}),m("th",{scope:"col",children:"show"})]})}),m("tbody",{children:n.modes.map(({frequency:t,name:i,quality:s})=>m("tr",{children:[m("td",{children:ca(t,e.unit.value)}),m("td",{children:i}),m("td",{children:s.toFixed(0)}),m("td",{children:m("button",{type:"button",onClick:()=>e.line.value=n.nearest(t),children:ca(n.frequency[n.nearest(t)]??0,e.unit.value)})})]}))})]})})}function dy({points:n,drawing:e}){let t=e?.plate.flat()??[],[i,s,r,o]=vp([...n,...t]),a=Math.max(s-i,o-r,1e-6),[l,c]=[.06*a,.045*a],u=[i-l,-o-l,s-i+2*l,o-r+2*l],[f,h]=[n[0],n.at(-1)];return m("svg",{class:"points",viewBox:u.map(d=>1e3*d).join(" "),role:"img","aria-label":WR(n,e),children:[e!==null&&m(ln,{children:[m("path",{d:e.plate.map(fy).join(""),class:"plate"}),m("path",{d:Object.values(e.regions).flat().map(fy).join(""),class:"region"})]}),m("path",{d:n.map(([d,p])=>`M${li(d)} ${li(-p)}h1e-4`).join(""),class:"places"}),f!==void 0&&m("path",{d:`M${li(f[0])} ${li(-f[1])}h1e-4`,class:"first"}),m("g",{"font-size":1e3*c,children:[Object.entries(e?.regions??{}).map(([d,p])=>{let[y,_,,g]=vp(p.flat());return m("text",{x:li((y+_)/2),y:li(1.2*c-g),"text-anchor":"middle",children:d})}),f!==void 0&&m(hy,{at:f,letter:c,words:"1"}),h!==void 0&&n.length>1&&m(hy,{at:h,letter:c,words:`${n.length}`}),m("text",{x:li(s+l),y:li(-r+.9*l),"text-anchor":"end",class:"quiet",children:"x →"}),m("text",{x:li(i-.9*l),y:li(-o-.2*l),class:"quiet",children:"y ↑"})]})]})}function hy({at:[n,e],letter:t,words:i}){return m("text",{x:li(n+.3*t),y:li(-e-.3*t),class:"number",children:i})}var li=n=>Number((1e3*n).toFixed(4)),fy=n=>`M${n.map(([e,t])=>`${li(e)} ${li(-t)}`).join("L")}Z`;function vp(n){let[e,t,i,s]=[1/0,-1/0,1/0,-1/0];for(let[r,o]of n)[e,t]=[Math.min(e,r),Math.max(t,r)],[i,s]=[Math.min(i,o),Math.max(s,o)];return[e,t,i,s]}function WR(n,e){let[t,i,s,r]=vp(n),o=(l,c)=>`${Number((1e3*l).toPrecision(4))} to ${Number((1e3*c).toPrecision(4))} mm`,a=e===null?"":" over the outline of the plate";return`${n.length} points${a}: x from ${o(t,i)}, y from ${o(s,r)}`}var qR=220,Eh=[[],[8,4]];function py(n){return m(XR,{data:n})}function XR({data:n}){let{points:e,drawing:t,curves:i,unit:s,axis:r,names:o}=Ge(()=>YR(n),[n]),a=n.values(r),l=Ge(()=>Array.from(a,c=>c/s.factor),[n]);return m("div",{class:"reading",children:[e.length>0&&m(dy,{points:e,drawing:t}),l.length>1&&m("div",{children:[m(es,{x:l,curves:i,titles:[Xt(n.title(r),s),$R(n,o)],height:qR}),o.length>1&&m("p",{class:"legend",children:o.map((c,u)=>m("span",{class:"of-curve",children:[m("svg",{width:"34",height:"8","aria-hidden":"true",children:m("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${u})`,"stroke-dasharray":(Eh[u%Eh.length]??[]).join(" ")})})," ",n.title(c)]}))})]})]})}function YR(n){let{extra:e,variables:t}=n.header,i=String(e.axis),s=Object.keys(t).filter(u=>u!==i&&t[u]?.dims[0]===i),r=s.map((u,f)=>({values:Array.from(n.values(u),h=>Number.isFinite(h)?h:null),colour:`curve-${f}`,dash:Eh[f%Eh.length]??[]})),o=n.has("y")?n.values("y"):[],a=n.has("x")?Array.from(n.values("x"),(u,f)=>[u,o[f]??0]):[],l={name:n.unit(i),factor:1},c=l.name==="Hz"?Ri(Ci(n),Math.max(...n.values(i))):l;return{points:a,drawing:e.drawing,curves:r,unit:c,axis:i,names:s}}function $R(n,e){let[t=""]=e;return Xt(e.length===1?n.title(t):"force",{name:n.unit(t),factor:1})}var ZR=40,KR=.42;function my({ribbon:n,choice:e}){let[t,i]=[e.unit.value,e.wavevectorUnit.value],s=e.mode.value,r=Ge(()=>Array.from(n.phases,l=>l/n.period/i.factor),[n,i]),o=Ge(()=>{let[l,c]=n.range;return{x:[0,Math.PI/n.period/i.factor],y:[l/t.factor,c/t.factor]}},[n,i,t]),a=(l,c,u=!1)=>[l.valToPos(n.wavevector(c)/i.factor,"x",u),l.valToPos(n.at(c)/t.factor,"y",u)];return m(es,{x:r,curves:JR,titles:[Xt("wavevector along the ribbon",i),Xt("frequency",t)],height:420,limits:o,below:l=>jR(l,n,r,t.factor),above:l=>{QR(l,n,t.factor,i.factor),n.carrier!==null&&To(l,n.carrier/t.factor,"carrier",[7,5]),As(l.ctx,a(l,s,!0),"accent")},pick:(l,c,u)=>{let[f,h]=[u.valToPos(l,"x"),u.valToPos(c,"y")],d=y=>Math.hypot(a(u,y)[0]-f,a(u,y)[1]-h),p=n.all.reduce((y,_)=>d(_)<d(y)?_:y,0);d(p)<ZR&&(e.mode.value=p)}})}var JR=[];function jR(n,e,t,i){let{ctx:s}=n;s.save(),s.globalAlpha=.4;for(let{crystal:r,lower:o,upper:a}of e.bulk()){s.fillStyle=Qe(r===0?"rule":`curve-${r}`),s.beginPath();let l=(c,u)=>s.lineTo(n.valToPos(t[u]??0,"x",!0),n.valToPos((c[u]??0)/i,"y",!0));t.forEach((c,u)=>l(a,u)),t.forEach((c,u)=>l(o,t.length-1-u)),s.fill()}s.restore()}function QR(n,e,t,i){let{ctx:s}=n,r=e.phases.length>1?(e.phases[1]??0)-(e.phases[0]??0):.1,o=KR*r/e.period;s.save();for(let a of e.all){let l=(e.velocity[a]??0)*o/(2*Math.PI),c=f=>[n.valToPos((e.wavevector(a)+f*o)/i,"x",!0),n.valToPos((e.at(a)+f*l)/t,"y",!0)],u=e.share[a]??0;s.strokeStyle=yp(e.shares,u),s.lineWidth=(e.isGuided(a)?3:1.4)*devicePixelRatio,s.beginPath(),s.moveTo(...c(-1)),s.lineTo(...c(1)),s.stroke()}s.restore()}function yp(n,e){let t=matchMedia("(prefers-color-scheme: dark)").matches?e:1-e;return`rgb(${(n[Math.round(Math.min(Math.max(t,0),1)*(n.length-1))]??[]).join(" ")})`}var eP=1.6,tP=30,nP=["across the ribbon","along the ribbon","normal to the plate"],Ah=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),this.phase=e.values("phase"),this.velocity=e.values("group_velocity"),this.share=e.values("guide_share"),this.phases=e.values("wavevector_phase"),this.period=Number(i.period),this.range=t.range,this.carrier=t.carrier,this.place=i.kind==="strip"?"the outermost columns":`the ${i.kind}`,this.units=Ci(e),this.wavevectorUnits=fo(this.period),this.shares=t.shares,this.atPhase=Array.from(this.phases,s=>this.all.filter(r=>this.phase[r]===s).sort((r,o)=>this.at(r)-this.at(o)))}data;frequency;error;phase;velocity;share;phases;period;range;carrier;place;units;wavevectorUnits;shares;atPhase;get all(){return Array.from(this.frequency,(e,t)=>t)}get hasFields(){return this.data.has("mode_real")}get fields(){let{data:e,period:t}=this,[,i=0,s=0]=e.shape("mode_real"),r=e.values("across"),o=((r[1]??0)-(r[0]??0))*i;return{grid:{...{real:e.values("mode_real"),imag:e.values("mode_imag"),present:e.values("present")},across:i,along:s,width:o,length:t,colours:e.header.extra.colours},part:{periods:Math.min(tP,Math.max(2,Math.round(eP*o/t)))}}}wave(e){return{number:e,phase:this.phase[e]??0,decay:0}}at(e){return this.frequency[e]??NaN}wavevector(e){return(this.phase[e]??0)/this.period}isGuided(e){return this.data.values("guided")[e]===1}decay(e){let[t,i]=["decay","decay_error"].map(s=>this.data.values(s)[e]??NaN);return Number.isFinite(t)?Gt(t,i):""}speed(e){return Gt(this.velocity[e]??NaN,this.data.values("group_velocity_error")[e]??NaN)}direction(e){return nP[this.data.values("mode_component")[e]??2]??""}get first(){let[e,t]=this.range,i=this.carrier!==null&&this.carrier>e&&this.carrier<t?this.carrier:(e+t)/2,s=this.all.filter(r=>this.isGuided(r));return gy(s.length>0?s:this.all,r=>this.at(r),i)}beside(e){return this.atPhase[this.row(e)]??[]}moved(e,t,i){let s=this.beside(e);if(i!==0)return s[Math.min(Math.max(s.indexOf(e)+i,0),s.length-1)]??e;let r=this.atPhase.map((a,l)=>l).filter(a=>(this.atPhase[a]??[]).length>0),o=Math.min(Math.max(r.indexOf(this.row(e))+t,0),r.length-1);return gy(this.atPhase[r[o]??0]??[],a=>this.at(a),this.at(e))}get guided(){return this.atPhase.flat().filter(e=>this.isGuided(e))}bulk(){let[e=0,t=0,i=0]=this.data.shape("bulk_lower"),[s,r]=[this.data.values("bulk_lower"),this.data.values("bulk_upper")];return Array.from({length:e*i},(o,a)=>{let[l,c]=[Math.floor(a/i),a%i],u=f=>Array.from({length:t},(h,d)=>f[(l*t+d)*i+c]??NaN);return{crystal:l,lower:u(s),upper:u(r)}})}row(e){return Array.from(this.phases).indexOf(this.phase[e]??NaN)}};function gy(n,e,t){return n.reduce((i,s)=>Math.abs(e(s)-t)<Math.abs(e(i)-t)?s:i,n[0]??0)}var _y="Errors of frequencies bound the distance to the exact ones of the model, those of velocity and decay are estimates. The field is that of the strongest component on the flat face, relative to its largest displacement.",iP="Fields of the modes are computed with the option --html.";function vy(n){return m(sP,{data:n})}function sP({data:n}){let e=Ge(()=>new Ah(n),[n]),t=Ge(()=>({mode:Xe(e.first),unit:Xe(Ri(e.units,e.range[1])),wavevectorUnit:Xe(e.wavevectorUnits[1]),...hs(),listing:Xe("none")}),[e]),i=Ge(()=>rP(e,t),[e,t]);return e.all.length===0?m(Jn,{name:"ribbon",data:n,keys:[],foot:_y,children:null}):m(Jn,{name:"ribbon",data:n,keys:i,foot:_y,children:[m("div",{class:"pair",children:[m("section",{"aria-label":"Projected bands",children:[m(Vn,{label:"Projected bands. Arrow keys move between wavevectors and modes.",children:m(my,{ribbon:e,choice:t})}),m("p",{class:"axes",children:[m(Pi,{title:"Frequencies in",units:e.units,unit:t.unit}),m(Pi,{title:"Wavevectors in",units:e.wavevectorUnits,unit:t.wavevectorUnit})]}),m(aP,{ribbon:e})]}),m("section",{"aria-label":"Mode",children:[e.hasFields?m(oP,{ribbon:e,choice:t}):m("p",{children:iP}),m(lP,{ribbon:e,choice:t}),e.hasFields&&m(po,{...t})]})]}),m(ii,{listing:t.listing,keys:i,children:m(cP,{ribbon:e,choice:t})})]})}function rP(n,e){let t=(s,r)=>e.mode.value=n.moved(e.mode.value,s,r),i=s=>{let{guided:r}=n;if(r.length===0)return;let o=r.indexOf(e.mode.value);e.mode.value=r[(o+s+r.length)%r.length]??e.mode.value};return[{keys:"← →",effect:"mode of about this frequency at the previous or next wavevector",actions:{ArrowLeft:()=>t(-1,0),ArrowRight:()=>t(1,0)}},{keys:"↑ ↓",effect:"next higher or lower mode at this wavevector",actions:{ArrowUp:()=>t(0,1),ArrowDown:()=>t(0,-1)}},{keys:"p n",effect:"previous or next guided mode",actions:{p:()=>i(-1),n:()=>i(1)}},cs(e),...ni(e.listing)]}function oP({ribbon:n,choice:e}){let{grid:t,part:i}=Ge(()=>n.fields,[n]),s=Ge(()=>xn(()=>n.wave(e.mode.value)),[n,e]),r=`${n.data.header.title}, ${Vi(n.data)}`;return m(aa,{grid:t,part:i,wave:s,pace:e,label:"Field of the mode",name:"ribbon",caption:r})}function aP({ribbon:n}){let[,e]=Zs(0);fn(()=>si(()=>e(i=>i+1)),[]);let t=[0,.25,.5,.75,1].map(i=>yp(n.shares,i));return m("p",{class:"scale legend",children:["0 %",m("span",{class:"bar",style:{background:`linear-gradient(to right, ${t.join(", ")})`}}),"100 % of the energy in ",n.place,"; guided modes are thick",n.carrier!==null&&m("span",{class:"of-carrier",children:"carrier"})]})}function yy(n,e,{factor:t,name:i}){return`${Number((n.wavevector(e)/t).toPrecision(4))} ${i}`}function xy(n){return`${(100*(n??NaN)).toFixed(1)} %`}function by(n,e,{factor:t}){return Gt(n.at(e)/t,(n.error[e]??NaN)/t)}function lP({ribbon:n,choice:e}){let[t,i,s]=[e.mode.value,e.unit.value,e.wavevectorUnit.value],r=n.decay(t),o=[["group velocity",`${n.speed(t)} m/s`],[`energy in ${n.place}`,xy(n.share[t])],["decay",r&&`${r} dB per row`],["shown displacement",n.hasFields?n.direction(t):""]];return m("div",{class:"facts",children:[m("p",{id:"point","aria-live":"polite",children:[n.isGuided(t)?"Guided mode":"Mode"," at ",yy(n,t,s),":"," ",m("b",{children:kn(by(n,t,i),i)})]}),m(Ii,{facts:o})]})}function cP({ribbon:n,choice:e}){let[t,i,s]=[e.mode.value,e.unit.value,e.wavevectorUnit.value];return m("div",{class:"wide",children:m("table",{children:[m("caption",{children:["Modes at ",yy(n,t,s)]}),m("thead",{children:m("tr",{children:[Xt("frequency",i),"guided",`energy in ${n.place}`,"decay / (dB/row)","show"].map(r=>m("th",{scope:"col",children:r}))})}),m("tbody",{children:n.beside(t).map(r=>m("tr",{"aria-current":r===t?"true":void 0,children:[m("td",{children:by(n,r,i)}),m("td",{children:n.isGuided(r)?"yes":"no"}),m("td",{children:xy(n.share[r])}),m("td",{children:n.decay(r)||"-"}),m("td",{children:m("button",{type:"button",onClick:()=>e.mode.value=r,children:kn(ls(n.at(r)/i.factor),i)})})]}))})]})})}var Sy='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var My=`& {
  --paper: #ffffff;
  --panel: #f5f6f7;
  --ink: #1c2126;
  --quiet: #4d565e;
  --rule: #c9ced3;
  --accent: #0a5ea8;
  --gap: #f3d9a4;
  --carrier: #b3123f;
  --curve-0: #0072b2;
  --curve-1: #b34e00;
  --curve-2: #007a59;
  --curve-3: #a0447c;
  color-scheme: light dark;
  background: var(--paper);
  color: var(--ink);
  font: 1rem/1.45 system-ui, sans-serif;
}
@media (prefers-color-scheme: dark) {
  & {
    --paper: #15181b;
    --panel: #1f2428;
    --ink: #e8eaec;
    --quiet: #b3bac0;
    --rule: #4a5258;
    --accent: #6db3f2;
    --gap: #5c4714;
    --carrier: #ff7d9c;
    --curve-0: #6db3f2;
    --curve-1: #ffb066;
    --curve-2: #4fd1a5;
    --curve-3: #f0a3cf;
  }
}
body { margin: 0; }
.view { container-type: inline-size; }
#view { max-width: 84rem; margin: 0 auto; padding: 0.75rem 1rem 2rem; }
h1 { font-size: 1.3rem; margin: 0; display: inline-block; }
.origin {
  display: inline-block; margin: 0 0 0 0.75rem; padding: 0 0.5rem;
  border: 1px solid var(--rule); border-radius: 0.75rem; color: var(--quiet); font-size: 0.85rem;
}
header p { margin: 0.25rem 0; max-width: 60rem; }
.pair { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr); margin-top: 0.75rem; }
@container (min-width: 52rem) { .pair { grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr); } }
.walk:focus-visible, button:focus-visible, input:focus-visible, select:focus-visible, canvas:focus-visible {
  outline: 3px solid var(--accent); outline-offset: 2px;
}
.curves { width: 100%; overflow: hidden; }
.mode canvas {
  display: block; width: 100%; height: clamp(17rem, 46vh, 30rem); background: var(--panel);
  border-radius: 0.4rem; touch-action: none;
}
.map canvas { display: block; max-width: 100%; background: var(--panel); }
.finger .map canvas { touch-action: none; cursor: pointer; }
.finger .map .bar { flex: 0 1 8rem; }
.axes label { max-width: 100%; }
.opened { display: flex; gap: 0.4rem; }
.legend .of-curve::before { display: none; }
.legend .of-curve { margin-right: 1rem; }
.legend > span { display: inline-block; }
.axes, .sides, .controls { display: flex; flex-wrap: wrap; gap: 0.4rem 1rem; align-items: center; margin: 0.5rem 0; }
.sides { gap: 0.4rem; font-size: 0.9rem; }
.scale { display: flex; flex-wrap: wrap; gap: 0.4rem; align-items: center; margin: 0.4rem 0; font-size: 0.85rem; }
.scale .bar { width: 8rem; height: 0.8rem; border: 1px solid var(--rule); }
.legend span::before { content: ""; display: inline-block; width: 1.4em; height: 0.8em; margin: 0 0.35em 0 0.9em; }
.legend .of-gap::before { background: var(--gap); border: 1px solid var(--rule); }
.legend .of-parity::before { background: repeating-linear-gradient(-45deg, var(--gap) 0 2px, transparent 2px 6px); border: 1px solid var(--rule); }
.legend .of-carrier::before { height: 0; border-top: 2px dashed var(--carrier); vertical-align: 0.25em; }
.legend .of-preview::before { height: 0; border-top: 2px dashed var(--accent); vertical-align: 0.25em; }
.legend .of-held::before { height: 0; border-top: 2px dotted var(--curve-1); vertical-align: 0.25em; }
/* the slider and the edges of the gap stay in sight above the curves */
.insight {
  position: sticky; top: 0; z-index: 2; display: flex; flex-wrap: wrap; gap: 0.2rem 1rem; align-items: center;
  background: var(--paper); border-bottom: 1px solid var(--rule); padding: 0.3rem 0;
}
.edges { display: flex; flex-wrap: wrap; gap: 0 1rem; margin: 0; font-variant-numeric: tabular-nums; }
.edges div { display: flex; gap: 0.4rem; align-items: baseline; }
.edges dt { color: var(--quiet); font-size: 0.85rem; }
.edges dd { margin: 0; }
.kind { color: var(--paper); background: var(--quiet); border-radius: 0.3rem; padding: 0 0.4rem; min-width: 4rem; text-align: center; font-size: 0.85rem; }
.kind.earlier { background: var(--carrier); }
.insight p { margin: 0; }
.kind.preview { background: var(--accent); }
.old { visibility: hidden; }
button.minor { padding: 0 0.45rem; min-height: 1.6rem; font-size: 0.85rem; }
button.minor[aria-pressed="true"] { border: 2px solid var(--accent); font-weight: 600; }
.turning { flex: 1 1 26rem; display: flex; flex-wrap: wrap; gap: 0.2rem 0.75rem; align-items: center; }
.turning input[type="range"] { flex: 1 1 12rem; }
/* of fixed widths, so that the slider does not change under the hand */
.turning output { flex: 0 0 7rem; font-variant-numeric: tabular-nums; }
.turning .state { font-size: 0.85rem; }
.facts p { margin: 0.4rem 0; }
.facts dl { display: flex; flex-wrap: wrap; gap: 0.2rem 1.5rem; margin: 0.4rem 0; }
.facts dt { color: var(--quiet); font-size: 0.85rem; }
.facts dd { margin: 0; }
.again { color: var(--quiet); font-size: 0.9rem; }
code { font: 0.95em ui-monospace, monospace; overflow-wrap: anywhere; }
.controls label { display: flex; flex-direction: column; font-size: 0.85rem; color: var(--quiet); }
.controls label.check { flex-direction: row; gap: 0.4rem; align-items: center; }
button, select, input[type="number"] {
  font: inherit; color: var(--ink); background: var(--panel); border: 1px solid var(--quiet);
  border-radius: 0.35rem; padding: 0.2rem 0.6rem; min-height: 1.9rem;
}
select { max-width: 100%; }
button { cursor: pointer; }
a { color: var(--accent); }
input[type="range"] { accent-color: var(--accent); min-width: 10rem; }
.controls .long { flex: 1 1 100%; }
.wide { overflow-x: auto; position: relative; }
table { border-collapse: collapse; margin: 0.5rem 0 1rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: 0.3rem 0; }
th, td { text-align: left; padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid var(--rule); font-weight: normal; }
thead th { color: var(--quiet); }
tr[aria-current] td { font-weight: 600; }
footer { color: var(--quiet); font-size: 0.85rem; }
.reading { display: grid; gap: 0.75rem; grid-template-columns: repeat(auto-fit, minmax(min(18rem, 100%), 1fr)); align-items: start; }
.points { width: 100%; max-height: 22rem; background: var(--panel); border: 1px solid var(--rule); border-radius: 0.3rem; }
.points path { fill: none; stroke: var(--quiet); stroke-width: 1.5px; vector-effect: non-scaling-stroke; }
.points .region { stroke: var(--curve-1); }
.points .places { stroke: var(--accent); stroke-width: 4px; stroke-linecap: round; }
.points .first { stroke: var(--carrier); stroke-width: 9px; stroke-linecap: round; }
.points text { fill: var(--ink); }
.points .number { font-weight: 700; paint-order: stroke; stroke: var(--panel); stroke-width: 3px; vector-effect: non-scaling-stroke; }
.maps { display: grid; gap: 0.5rem 1rem; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); }
.maps h2 { font-size: 1rem; margin: 0.2rem 0; }
.estimates { width: 100%; max-width: 60rem; display: block; }
.estimates text { fill: var(--ink); font-size: 13px; }
.estimates .quiet { fill: var(--quiet); }
.estimates line { stroke: var(--rule); }
.estimates .interval { stroke: var(--curve-0); stroke-width: 2; }
.estimates circle { fill: var(--curve-0); }
.estimates .whole .interval { stroke: var(--curve-1); stroke-width: 4; }
.estimates .mark { fill: var(--curve-1); }
.estimates .whole text { font-weight: 700; }
.estimates .trial { fill: none; stroke: var(--quiet); }
.friction td:last-child { min-width: 14rem; }
.estimates .chosen { fill: var(--panel); stroke: var(--accent); }
`;var fP={bands:Cv,layers:Qv,plate:ly,scan:cy,finger:Yv,ribbon:vy,friction:Zv,reading:py,guides:Rv};function xp(n,e,t){let i=fP[n.header.kind];if(i===void 0)throw new Error(`this version has no view "${n.header.kind}"`);return dP(),e.classList.add("haptonic","view"),$h(i(n,t),e),()=>$h(null,e)}function dP(){if(document.getElementById("haptonic-style")!==null)return;let n=document.createElement("style");n.id="haptonic-style",n.textContent=`${Sy}:where(.haptonic) { ${My} }`,document.head.append(n)}async function pP({model:n,el:e}){e.dataset.lmSuppressShortcuts="true";let{buffer:t,byteOffset:i,byteLength:s}=n.get("data");return xp(va.read(await Bh(new Uint8Array(t,i,s))),e)}async function wy(n){let e=document.getElementById(n.dataset.view??"")?.textContent??"";try{let t=Uint8Array.from(atob(e.trim()),s=>s.charCodeAt(0)),i=va.read(await Bh(t));return n.replaceChildren(),xp(i,n)}catch(t){let i=document.createElement("p");return i.textContent=`The view cannot be shown: ${t instanceof Error?t.message:String(t)}`,n.replaceChildren(i),()=>{}}}var Ml=null;function mP(n,e){let t=document.createElement("button"),i=document.createElement("div");t.type="button";let s=null,r=()=>{s?.(),i.remove(),t.textContent=e,t.ariaExpanded="false",[Ml,s]=[null,null]};t.addEventListener("click",async()=>{let o=Ml===r;if(Ml?.(),o)return;Ml=r,t.textContent="Close the view",t.ariaExpanded="true",n.append(i),i.dataset.view=n.dataset.view??"";let a=await wy(i);Ml===r?s=a:a()}),r(),n.append(t)}for(let n of document.querySelectorAll("[data-view]")){let e=n.dataset.opens;e===void 0?wy(n):mP(n,e)}var jO={render:pP};export{jO as default};
