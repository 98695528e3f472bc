<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>ClothView</name>
    <message>
        <source>selvedge</source>
        <translation>Webkante</translation>
    </message>
    <message>
        <source>fold of the cloth</source>
        <translation>Stoffbruch</translation>
    </message>
    <message>
        <source>warp</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>grade %1</source>
        <translation>Güte %1</translation>
    </message>
</context>
<context>
    <name>ColourBar</name>
    <message>
        <source>&lt;1</source>
        <translation>&lt;1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (hatched)</source>
        <translation>%1 (schraffiert)</translation>
    </message>
    <message>
        <source>%1: %2%4 to %3%4</source>
        <translation>%1: %2%4 bis %3%4</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>sewing in progress</source>
        <translation>wird gerade genäht</translation>
    </message>
    <message>
        <source>no current proof; prove by sewing first</source>
        <translation>keine aktuelle Prüfung; zuerst durch Nähen prüfen</translation>
    </message>
    <message>
        <source>designer&apos;s panels · %1</source>
        <translation>Teile des Entwerfers · %1</translation>
    </message>
    <message>
        <source>reference pattern · %1</source>
        <translation>Referenzschnitt · %1</translation>
    </message>
    <message>
        <source>%1 beyond the limits (hatched)</source>
        <translation>%1 außerhalb der Grenzen (schraffiert)</translation>
    </message>
    <message>
        <source>all within the limits</source>
        <translation>alles in den Grenzen</translation>
    </message>
</context>
<context>
    <name>ExportJob</name>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Drawing the pattern</source>
        <translation>Schnitt wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>FabricName</name>
    <message>
        <source>woven</source>
        <translation>Webstoff</translation>
    </message>
    <message>
        <source>denim</source>
        <translation>Denim</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>Canvas</translation>
    </message>
    <message>
        <source>jersey</source>
        <translation>Jersey</translation>
    </message>
    <message>
        <source>spandex</source>
        <translation>Elastan</translation>
    </message>
    <message>
        <source>neoprene</source>
        <translation>Neopren</translation>
    </message>
    <message>
        <source>leather</source>
        <translation>Leder</translation>
    </message>
    <message>
        <source>faux leather</source>
        <translation>Kunstleder</translation>
    </message>
    <message>
        <source>EVA foam</source>
        <translation>EVA-Schaum</translation>
    </message>
    <message>
        <source>custom</source>
        <translation>eigenes</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht festgelegt</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open a garment</source>
        <translation>Kleidungsstück öffnen</translation>
    </message>
    <message>
        <source>3D garments (%1);;All files (*)</source>
        <translation>3D-Kleidungsstücke (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Seams files (*.json);;All files (*)</source>
        <translation>Nahtdateien (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the pattern</source>
        <translation>Schnittmuster exportieren</translation>
    </message>
    <message>
        <source>Garments and projects (%1);;All files (*)</source>
        <translation>Kleidungsstücke und Projekte (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Toile projects (*.toile)</source>
        <translation>Toile-Projekte (*.toile)</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Wo ist %1?</translation>
    </message>
    <message>
        <source>Replace the file?</source>
        <translation>Datei ersetzen?</translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation>Trotzdem speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Open a reference pattern</source>
        <translation>Einen Referenzschnitt öffnen</translation>
    </message>
    <message>
        <source>Patterns (%1);;All files (*)</source>
        <translation>Schnitte (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the changes to the project %1?</source>
        <translation>Die Änderungen am Projekt %1 speichern?</translation>
    </message>
    <message>
        <source>Save the pattern made from %1 as a project?</source>
        <translation>Den Schnitt aus %1 als Projekt speichern?</translation>
    </message>
    <message>
        <source>Open hides</source>
        <translation>Häute öffnen</translation>
    </message>
    <message>
        <source>Drawings (%1);;All files (*)</source>
        <translation>Zeichnungen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a body</source>
        <translation>Körper öffnen</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Netze (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Your changes since the last save are lost if you do not save them.</source>
        <translation>Ohne Speichern gehen Ihre Änderungen seit dem letzten Speichern verloren.</translation>
    </message>
    <message>
        <source>Your work is lost if you do not save it. The garment&apos;s file is never changed.</source>
        <translation>Ohne Speichern geht Ihre Arbeit verloren. Die Datei des Kleidungsstücks bleibt unverändert.</translation>
    </message>
    <message>
        <source>Another program has changed %1 since you opened it. Save anyway?</source>
        <translation>Ein anderes Programm hat %1 geändert, seit Sie es geöffnet haben. Trotzdem speichern?</translation>
    </message>
    <message>
        <source>If you save, the other program&apos;s changes are lost.</source>
        <translation>Wenn Sie speichern, gehen die Änderungen des anderen Programms verloren.</translation>
    </message>
    <message>
        <source>The file %1 already exists. Replace it?</source>
        <translation>Die Datei %1 gibt es schon. Soll sie ersetzt werden?</translation>
    </message>
    <message>
        <source>Load cuts and ease</source>
        <translation>Einschnitte und Einhalteweiten laden</translation>
    </message>
</context>
<context>
    <name>GarmentView</name>
    <message>
        <source>seam %1: %2</source>
        <translation>Naht %1: %2</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
</context>
<context>
    <name>GlSupport</name>
    <message>
        <source>The views need OpenGL 3.3, which is not available. Flattening and export still work. Update the graphics driver to get the views.</source>
        <translation>Die Ansichten brauchen OpenGL 3.3, das nicht verfügbar ist. Abwickeln und Exportieren gehen trotzdem. Aktualisieren Sie den Grafiktreiber, um die Ansichten zu sehen.</translation>
    </message>
    <message>
        <source>The views need OpenGL 3.3, but the graphics driver only offers %1.%2. Flattening and export still work. Update the driver to get the views.</source>
        <translation>Die Ansichten brauchen OpenGL 3.3, aber der Grafiktreiber bietet nur %1.%2. Abwickeln und Exportieren gehen trotzdem. Aktualisieren Sie den Treiber, um die Ansichten zu sehen.</translation>
    </message>
</context>
<context>
    <name>GrainJob</name>
    <message>
        <source>Finding the grain</source>
        <translation>Der Fadenlauf wird gesucht</translation>
    </message>
</context>
<context>
    <name>ImportJob</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
</context>
<context>
    <name>MoveGesture</name>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
</context>
<context>
    <name>OffscreenContext</name>
    <message>
        <source>pictures need OpenGL 3.3, but neither a display nor a driver without display offers it; use xvfb-run, or install the package libgl1-mesa-dri</source>
        <translation>Bilder brauchen OpenGL 3.3, aber weder ein Bildschirm noch ein Treiber ohne Bildschirm bietet es; benutzen Sie xvfb-run oder installieren Sie das Paket libgl1-mesa-dri</translation>
    </message>
</context>
<context>
    <name>OldOutlines</name>
    <message>
        <source>%1
out of date</source>
        <translation>%1
veraltet</translation>
    </message>
</context>
<context>
    <name>PatternView</name>
    <message>
        <source>The flat pieces appear here.</source>
        <translation>Hier erscheinen die flachen Schnittteile.</translation>
    </message>
    <message>
        <source>%1 · wrong side up</source>
        <translation>%1 · linke Stoffseite oben</translation>
    </message>
    <message>
        <source>%1 · cut with %2</source>
        <translation>%1 · mit %2 zuschneiden</translation>
    </message>
    <message>
        <source>fold</source>
        <translation>Stoffbruch</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Schnittmuster</translation>
    </message>
    <message>
        <source>right side of the fabric up, seam lines</source>
        <translation>rechte Stoffseite oben, Nahtlinien</translation>
    </message>
    <message>
        <source>right side of the fabric up, cutting and seam lines</source>
        <translation>rechte Stoffseite oben, Schnitt- und Nahtlinien</translation>
    </message>
    <message>
        <source>The pieces have changed and are not flattened yet.</source>
        <translation>Die Schnittteile haben sich geändert und sind noch nicht abgewickelt.</translation>
    </message>
    <message>
        <source>No piece could be flattened. See the list of pieces for the reasons.</source>
        <translation>Kein Schnittteil ließ sich abwickeln. Die Gründe stehen in der Liste der Schnittteile.</translation>
    </message>
</context>
<context>
    <name>PlatformChoice</name>
    <message>
        <source>there is no display for the window; use xvfb-run, or &quot;toile flatten&quot; and &quot;toile render&quot;, which need none</source>
        <translation>es gibt keinen Bildschirm für das Fenster; benutzen Sie xvfb-run, oder „toile flatten“ und „toile render“, die keinen brauchen</translation>
    </message>
    <message>
        <source>there is no display, and Qt&apos;s offscreen plugin is not installed; use xvfb-run</source>
        <translation>es gibt keinen Bildschirm, und das Offscreen-Plugin von Qt ist nicht installiert; benutzen Sie xvfb-run</translation>
    </message>
</context>
<context>
    <name>ProjectJob</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
</context>
<context>
    <name>ProofJob</name>
    <message>
        <source>Sewing the pattern back together</source>
        <translation>Der Schnitt wird zusammengenäht</translation>
    </message>
</context>
<context>
    <name>ProposedCut</name>
    <message>
        <source>left side</source>
        <translation>linke Seitennaht</translation>
    </message>
    <message>
        <source>right side</source>
        <translation>rechte Seitennaht</translation>
    </message>
    <message>
        <source>left underarm</source>
        <translation>linke Unterarmnaht</translation>
    </message>
    <message>
        <source>right underarm</source>
        <translation>rechte Unterarmnaht</translation>
    </message>
    <message>
        <source>left armhole</source>
        <translation>linkes Armloch</translation>
    </message>
    <message>
        <source>right armhole</source>
        <translation>rechtes Armloch</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>linke Schulternaht</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>rechte Schulternaht</translation>
    </message>
    <message>
        <source>left inseam</source>
        <translation>linke Schrittnaht</translation>
    </message>
    <message>
        <source>right inseam</source>
        <translation>rechte Schrittnaht</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mittelnaht</translation>
    </message>
    <message>
        <source>waist</source>
        <translation>Taillennaht</translation>
    </message>
    <message>
        <source>style line</source>
        <translation>Teilungsnaht</translation>
    </message>
    <message>
        <source>left style line</source>
        <translation>linke Teilungsnaht</translation>
    </message>
    <message>
        <source>right style line</source>
        <translation>rechte Teilungsnaht</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>dart</source>
        <translation>Abnäher</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>Öffnungsschnitt</translation>
    </message>
    <message>
        <source>band</source>
        <translation>Bundnaht</translation>
    </message>
</context>
<context>
    <name>ProposedPart</name>
    <message>
        <source>body</source>
        <translation>Rumpf</translation>
    </message>
    <message>
        <source>front</source>
        <translation>Vorderteil</translation>
    </message>
    <message>
        <source>back</source>
        <translation>Rückenteil</translation>
    </message>
    <message>
        <source>sleeve</source>
        <translation>Ärmel</translation>
    </message>
    <message>
        <source>leg</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>skirt</source>
        <translation>Rock</translation>
    </message>
    <message>
        <source>bodice</source>
        <translation>Oberteil</translation>
    </message>
    <message>
        <source>neck band</source>
        <translation>Halsbündchen</translation>
    </message>
    <message>
        <source>waistband</source>
        <translation>Bund</translation>
    </message>
    <message>
        <source>hem band</source>
        <translation>Saumbündchen</translation>
    </message>
    <message>
        <source>cuff</source>
        <translation>Bündchen</translation>
    </message>
    <message>
        <source>armhole band</source>
        <translation>Armlochblende</translation>
    </message>
    <message>
        <source>left %1</source>
        <translation>%1 links</translation>
    </message>
    <message>
        <source>right %1</source>
        <translation>%1 rechts</translation>
    </message>
    <message>
        <source>%1 front</source>
        <translation>%1 vorn</translation>
    </message>
    <message>
        <source>%1 back</source>
        <translation>%1 hinten</translation>
    </message>
</context>
<context>
    <name>RecomputeJob</name>
    <message>
        <source>Making the pieces</source>
        <translation>Schnittteile werden gebildet</translation>
    </message>
    <message>
        <source>Flattening the pieces</source>
        <translation>Schnittteile werden abgewickelt</translation>
    </message>
    <message>
        <source>Drawing the pieces</source>
        <translation>Schnittteile werden gezeichnet</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>Remedy</name>
    <message>
        <source>Flatten now</source>
        <translation>Jetzt abwickeln</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Aufschneiden</translation>
    </message>
    <message>
        <source>Set unit…</source>
        <translation>Einheit angeben…</translation>
    </message>
    <message>
        <source>Set axis…</source>
        <translation>Achse angeben…</translation>
    </message>
    <message>
        <source>Choose the axis of the file that points up</source>
        <translation>Die Achse der Datei wählen, die nach oben zeigt</translation>
    </message>
    <message>
        <source>Turn inside out</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Best grain</source>
        <translation>Bester Fadenlauf</translation>
    </message>
    <message>
        <source>Lay out again</source>
        <translation>Neu auslegen</translation>
    </message>
    <message>
        <source>Propose cuts…</source>
        <translation>Schnitte vorschlagen …</translation>
    </message>
    <message>
        <source>Show strain</source>
        <translation>Dehnung zeigen</translation>
    </message>
    <message>
        <source>Colour the pieces by strain</source>
        <translation>Die Schnittteile nach ihrer Dehnung einfärben</translation>
    </message>
    <message>
        <source>Flatten the pieces that are out of date</source>
        <translation>Die veralteten Schnittteile abwickeln</translation>
    </message>
    <message>
        <source>Split by UV</source>
        <translation>Nach UV teilen</translation>
    </message>
    <message>
        <source>Make each UV island of the file one piece; you can undo this</source>
        <translation>Jede UV-Insel der Datei zu einem Schnittteil machen; lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Cut this piece open along short seams; you can undo this</source>
        <translation>Dieses Schnittteil entlang kurzer Nähte aufschneiden; lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Show where a tailor would cut this piece, and the effect on strain</source>
        <translation>Zeigen, wo ein Schneider dieses Schnittteil einschneiden würde, und die Wirkung auf die Dehnung</translation>
    </message>
    <message>
        <source>Choose the unit of the file, or enter the garment&apos;s height</source>
        <translation>Die Einheit der Datei wählen oder die Höhe des Kleidungsstücks eingeben</translation>
    </message>
    <message>
        <source>Flip all faces of the garment</source>
        <translation>Alle Flächen des Kleidungsstücks wenden</translation>
    </message>
    <message>
        <source>Set ease…</source>
        <translation>Einhalteweite setzen…</translation>
    </message>
    <message>
        <source>Set how much longer one side of the seam is</source>
        <translation>Festlegen, wie viel länger eine Seite der Naht ist</translation>
    </message>
    <message>
        <source>Run the grain upwards, or turn it 45° or 90° if that strains much less</source>
        <translation>Den Fadenlauf nach oben legen, oder um 45° oder 90° gedreht, wenn das viel weniger dehnt</translation>
    </message>
    <message>
        <source>Add dart</source>
        <translation>Abnäher setzen</translation>
    </message>
    <message>
        <source>Propose a dart to the worst place: Enter cuts it, Esc discards it</source>
        <translation>Einen Abnäher zur schlimmsten Stelle vorschlagen: Eingabe schneidet ihn, Esc verwirft ihn</translation>
    </message>
    <message>
        <source>Arrange all pieces in rows</source>
        <translation>Alle Schnittteile in Reihen anordnen</translation>
    </message>
</context>
<context>
    <name>RotateGesture</name>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
</context>
<context>
    <name>Ruler</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
</context>
<context>
    <name>RunWindow</name>
    <message>
        <source>could not write %1</source>
        <translation>%1 konnte nicht geschrieben werden</translation>
    </message>
</context>
<context>
    <name>SaveJob</name>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
</context>
<context>
    <name>SceneRenderer</name>
    <message>
        <source>This view needs OpenGL 3.3, which the graphics driver does not offer.</source>
        <translation>Diese Ansicht braucht OpenGL 3.3, das der Grafiktreiber nicht bietet.</translation>
    </message>
    <message>
        <source>The graphics driver cannot draw this view (%1).</source>
        <translation>Der Grafiktreiber kann diese Ansicht nicht zeichnen (%1).</translation>
    </message>
</context>
<context>
    <name>SeamFit</name>
    <message>
        <source>matches</source>
        <translation>passt</translation>
    </message>
    <message>
        <source>nearly</source>
        <translation>fast</translation>
    </message>
    <message>
        <source>does not match</source>
        <translation>passt nicht</translation>
    </message>
</context>
<context>
    <name>ViewPicture</name>
    <message>
        <source>the graphics driver cannot draw %1 x %2 pixels; choose a smaller size</source>
        <translation>der Grafiktreiber kann %1 x %2 Bildpunkte nicht zeichnen; wählen Sie eine kleinere Größe</translation>
    </message>
    <message>
        <source>there is not enough memory for a picture of this size</source>
        <translation>für ein Bild dieser Größe reicht der Speicher nicht</translation>
    </message>
</context>
<context>
    <name>WelcomePage</name>
    <message>
        <source>T-shirt</source>
        <translation>T-Shirt</translation>
    </message>
    <message>
        <source>Bodice</source>
        <translation>Mieder</translation>
    </message>
    <message>
        <source>Cap</source>
        <translation>Kappe</translation>
    </message>
    <message>
        <source>Skirt</source>
        <translation>Rock</translation>
    </message>
    <message>
        <source>Trousers</source>
        <translation>Hose</translation>
    </message>
</context>
<context>
    <name>WindowMenus</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
</context>
<context>
    <name>toile</name>
    <message>
        <source>MakeHuman works in decimetres</source>
        <translation>MakeHuman arbeitet in Dezimetern</translation>
    </message>
    <message>
        <source>a garment of %1 mm is unusual</source>
        <translation>ein Kleidungsstück von %1 mm ist ungewöhnlich</translation>
    </message>
    <message>
        <source>stated in a comment of the file</source>
        <translation>in einem Kommentar der Datei angegeben</translation>
    </message>
    <message>
        <source>a ZIP archive, as 3MF is</source>
        <translation>ein ZIP-Archiv, wie es 3MF ist</translation>
    </message>
    <message>
        <source>a LightWave scene</source>
        <translation>eine LightWave-Szene</translation>
    </message>
    <message>
        <source>its buffer &quot;%1&quot; is not in its folder; export it again with its files in the same folder, or as .glb</source>
        <translation>ihr Puffer „%1“ liegt nicht in ihrem Ordner; exportieren Sie sie neu, mit ihren Dateien daneben oder als .glb</translation>
    </message>
    <message>
        <source>%1 mm is unusual for &quot;%2&quot; in its name</source>
        <translation>%1 mm ist ungewöhnlich für „%2“ in ihrem Namen</translation>
    </message>
    <message>
        <source>z is up in 3MF files</source>
        <translation>in 3MF-Dateien ist z oben</translation>
    </message>
    <message>
        <source>it is too large: its meshes are %1 MB unpacked, too much for an archive of %2 MB; unpack it and open the mesh</source>
        <translation>sie ist zu groß: ihre Netze haben entpackt %1 MB, zu viel für ein Archiv von %2 MB; entpacken Sie es und öffnen Sie das Netz</translation>
    </message>
    <message>
        <source>stated in the 3MF file</source>
        <translation>in der 3MF-Datei angegeben</translation>
    </message>
    <message>
        <source>binary glTF</source>
        <translation>binäres glTF</translation>
    </message>
    <message>
        <source>glTF as text</source>
        <translation>glTF als Text</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>Check its name and permissions</source>
        <translation>Prüfen Sie Namen und Rechte</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>die Datei lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the file breaks the rules of its format</source>
        <translation>die Datei verletzt die Regeln ihres Formats</translation>
    </message>
    <message>
        <source>Export the garment as a mesh with faces, or the pattern with closed outlines</source>
        <translation>Exportieren Sie das Kleidungsstück als Netz mit Flächen, oder den Schnitt mit geschlossenen Umrissen</translation>
    </message>
    <message>
        <source>the project file breaks the rules of its format</source>
        <translation>die Projektdatei verletzt die Regeln ihres Formats</translation>
    </message>
    <message>
        <source>the project was saved by a newer version of Toile</source>
        <translation>das Projekt wurde von einer neueren Fassung von Toile gespeichert</translation>
    </message>
    <message>
        <source>faces have fewer than three different corners</source>
        <translation>Flächen haben weniger als drei verschiedene Ecken</translation>
    </message>
    <message>
        <source>vertices belong to no face</source>
        <translation>Punkte gehören zu keiner Fläche</translation>
    </message>
    <message>
        <source>a mesh written from this file differs from it</source>
        <translation>ein aus dieser Datei geschriebenes Netz weicht von ihr ab</translation>
    </message>
    <message>
        <source>Check them in the list of seams</source>
        <translation>Prüfen Sie sie in der Liste der Nähte</translation>
    </message>
    <message>
        <source>triangles have no area</source>
        <translation>Dreiecke haben keine Fläche</translation>
    </message>
    <message>
        <source>edges are shared by more than two faces</source>
        <translation>Kanten gehören zu mehr als zwei Flächen</translation>
    </message>
    <message>
        <source>the flat outline crosses itself</source>
        <translation>der flache Umriss kreuzt sich selbst</translation>
    </message>
    <message>
        <source>Cut the piece where it curves most if the pattern looks folded there</source>
        <translation>Schneiden Sie das Schnittteil dort ein, wo es sich am meisten krümmt, wenn das Schnittmuster da gefaltet aussieht</translation>
    </message>
    <message>
        <source>the piece is closed and has no outline</source>
        <translation>das Schnittteil ist geschlossen und hat keinen Umriss</translation>
    </message>
    <message>
        <source>the piece has several boundary loops</source>
        <translation>das Schnittteil hat mehrere Ränder</translation>
    </message>
    <message>
        <source>the piece has a handle, like a ring or a cup</source>
        <translation>das Schnittteil hat einen Henkel wie ein Ring oder eine Tasse</translation>
    </message>
    <message>
        <source>Separate the layers that meet there</source>
        <translation>Trennen Sie die Lagen, die dort aufeinandertreffen</translation>
    </message>
    <message>
        <source>Separate the parts, or join them along an edge</source>
        <translation>Trennen Sie die Teile oder verbinden Sie sie entlang einer Kante</translation>
    </message>
    <message>
        <source>Make the normals consistent in the modelling program</source>
        <translation>Gleichen Sie die Normalen im Modellierprogramm an</translation>
    </message>
    <message>
        <source>Cut it across</source>
        <translation>Schneiden Sie es quer durch</translation>
    </message>
    <message>
        <source>boundary edges have no length</source>
        <translation>Randkanten haben keine Länge</translation>
    </message>
    <message>
        <source>Merge the doubled vertices in the modelling program</source>
        <translation>Verschmelzen Sie die doppelten Punkte im Modellierprogramm</translation>
    </message>
    <message>
        <source>the cut cannot be made</source>
        <translation>der Einschnitt ist nicht möglich</translation>
    </message>
    <message>
        <source>Move its points, or repair the piece first</source>
        <translation>Verschieben Sie seine Punkte oder bessern Sie zuerst das Schnittteil aus</translation>
    </message>
    <message>
        <source>the garment has no seam of this name</source>
        <translation>das Kleidungsstück hat keine Naht dieses Namens</translation>
    </message>
    <message>
        <source>Cut the piece where it curves most, or choose the other boundary solver</source>
        <translation>Schneiden Sie das Schnittteil dort ein, wo es sich am meisten krümmt, oder wählen Sie den anderen Umrisslöser</translation>
    </message>
    <message>
        <source>the result is not a finite number</source>
        <translation>das Ergebnis ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>Close other programs, or flatten fewer or coarser pieces at a time</source>
        <translation>Schließen Sie andere Programme oder wickeln Sie weniger oder gröbere Schnittteile auf einmal ab</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Not flattened</source>
        <translation>Nicht abgewickelt</translation>
    </message>
    <message>
        <source>Outlines that cross themselves</source>
        <translation>Umrisse, die sich selbst kreuzen</translation>
    </message>
    <message>
        <source>Choose another method, or cut the piece where it curves most</source>
        <translation>Wählen Sie ein anderes Verfahren oder schneiden Sie das Schnittteil dort ein, wo es sich am meisten krümmt</translation>
    </message>
    <message>
        <source>Seams that do not match</source>
        <translation>Nähte, die nicht passen</translation>
    </message>
    <message>
        <source>Strain along the warp</source>
        <translation>Dehnung längs der Kette</translation>
    </message>
    <message>
        <source>Strain along the weft</source>
        <translation>Dehnung längs des Schusses</translation>
    </message>
    <message>
        <source>Strain on the bias</source>
        <translation>Dehnung im Schrägen</translation>
    </message>
    <message>
        <source>Move them apart, or lay them out again</source>
        <translation>Schieben Sie sie auseinander oder legen Sie sie neu aus</translation>
    </message>
    <message>
        <source>Unlikely size</source>
        <translation>Unwahrscheinliche Größe</translation>
    </message>
    <message>
        <source>Inside out</source>
        <translation>Innen nach außen</translation>
    </message>
    <message>
        <source>Grain not set</source>
        <translation>Fadenlauf nicht angegeben</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>seam line, no allowance</source>
        <translation>Nahtlinie, ohne Zugabe</translation>
    </message>
    <message>
        <source>mirrored: wrong side of the fabric up</source>
        <translation>gespiegelt: linke Stoffseite oben</translation>
    </message>
    <message>
        <source>cut %1</source>
        <translation>%1 × zuschneiden</translation>
    </message>
    <message>
        <source>cut 1 pair</source>
        <translation>1 Paar zuschneiden</translation>
    </message>
    <message>
        <source>cut %1 pairs</source>
        <translation>%1 Paare zuschneiden</translation>
    </message>
    <message>
        <source>check square 100 mm x 100 mm</source>
        <translation>Prüfquadrat 100 mm x 100 mm</translation>
    </message>
    <message>
        <source>cut %1 on fold</source>
        <translation>%1 × im Stoffbruch zuschneiden</translation>
    </message>
    <message>
        <source>place on fold</source>
        <translation>an den Stoffbruch legen</translation>
    </message>
    <message>
        <source>piece %1 of %2</source>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>size %1</source>
        <translation>Größe %1</translation>
    </message>
    <message>
        <source>seam allowance included</source>
        <translation>Nahtzugabe enthalten</translation>
    </message>
    <message>
        <source>another program has changed it</source>
        <translation>ein anderes Programm hat sie geändert</translation>
    </message>
    <message>
        <source>1 corner</source>
        <translation>1 Ecke</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>1 crossing</source>
        <translation>1 Kreuzung</translation>
    </message>
    <message>
        <source>%1 crossings</source>
        <translation>%1 Kreuzungen</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 Kante</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 Kanten</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 Fläche</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>1 handle</source>
        <translation>1 Henkel</translation>
    </message>
    <message>
        <source>%1 handles</source>
        <translation>%1 Henkel</translation>
    </message>
    <message>
        <source>1 hole</source>
        <translation>1 Loch</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1 Löcher</translation>
    </message>
    <message>
        <source>1 loop</source>
        <translation>1 Rand</translation>
    </message>
    <message>
        <source>%1 loops</source>
        <translation>%1 Ränder</translation>
    </message>
    <message>
        <source>1 outline vertex</source>
        <translation>1 Punkt des Umrisses</translation>
    </message>
    <message>
        <source>%1 outline vertices</source>
        <translation>%1 Punkte des Umrisses</translation>
    </message>
    <message>
        <source>1 panel</source>
        <translation>1 Schnittteil</translation>
    </message>
    <message>
        <source>%1 panels</source>
        <translation>%1 Schnittteilen</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 Dreieck</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1; %2; %3)</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1; %2; %3</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>the cuts would separate the piece</source>
        <translation>die Einschnitte würden das Schnittteil zerteilen</translation>
    </message>
    <message>
        <source>the mesh has several parts</source>
        <translation>das Netz hat mehrere Teile</translation>
    </message>
    <message>
        <source>points %1 and %2 of a path share no triangle</source>
        <translation>die Punkte %1 und %2 eines Weges liegen in keinem gemeinsamen Dreieck</translation>
    </message>
    <message>
        <source>the points lie on parts that are not connected</source>
        <translation>die Punkte liegen auf Teilen, die nicht zusammenhängen</translation>
    </message>
    <message>
        <source>it needs %1 points or more</source>
        <translation>mindestens %1 Punkte sind nötig</translation>
    </message>
    <message>
        <source>a point is not finite</source>
        <translation>die Koordinaten eines Punktes sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>boundary lengths or angles are not finite</source>
        <translation>Längen oder Winkel des Randes sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>(%1, %2)</source>
        <translation>(%1; %2)</translation>
    </message>
    <message>
        <source>%1 crossings or more</source>
        <translation>%1 Kreuzungen oder mehr</translation>
    </message>
    <message>
        <source>; no cut through the inside was found</source>
        <translation>; kein Einschnitt durch das Innere wurde gefunden</translation>
    </message>
    <message>
        <source>; cut it from %1 to %2, %3 mm</source>
        <translation>; schneiden Sie es von %1 bis %2 ein, %3 mm</translation>
    </message>
    <message>
        <source>; one cut is not enough: begin with one from %1 to %2, %3 mm</source>
        <translation>; ein Einschnitt reicht nicht: beginnen Sie mit einem von %1 bis %2, %3 mm</translation>
    </message>
    <message>
        <source>face %1 at %2 mm</source>
        <translation>Fläche %1 bei %2 mm</translation>
    </message>
    <message>
        <source>%1, %2 degrees at %3 mm</source>
        <translation>%1, %2 Grad bei %3 mm</translation>
    </message>
    <message>
        <source>%1 mm flat, %2 mm on the garment</source>
        <translation>%1 mm flach, %2 mm am Kleidungsstück</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>a rim would cross itself</source>
        <translation>ein Rand würde sich selbst kreuzen</translation>
    </message>
    <message>
        <source>the outline would cross itself</source>
        <translation>der Umriss würde sich selbst kreuzen</translation>
    </message>
    <message>
        <source>after %1 steps</source>
        <translation>nach %1 Schritten</translation>
    </message>
    <message>
        <source>it has no points</source>
        <translation>er hat keine Punkte</translation>
    </message>
    <message>
        <source>there is no piece to cut</source>
        <translation>es gibt kein Schnittteil zum Einschneiden</translation>
    </message>
    <message>
        <source>in %1, %2</source>
        <translation>in %1: %2</translation>
    </message>
    <message>
        <source>%1 and %2 come from different files</source>
        <translation>%1 und %2 stammen aus verschiedenen Dateien</translation>
    </message>
    <message>
        <source>no piece has an edge</source>
        <translation>kein Schnittteil hat einen Rand</translation>
    </message>
    <message>
        <source>%1, the result: %2</source>
        <translation>%1, das Ergebnis: %2</translation>
    </message>
    <message>
        <source>the UV map is a flat pattern of %1 (%2 % of its edges keep their length)</source>
        <translation>die UV-Abwicklung ist ein flacher Schnitt aus %1 (%2 % ihrer Kanten behalten ihre Länge)</translation>
    </message>
    <message>
        <source>the file names %1 objects</source>
        <translation>die Datei nennt %1 Objekte</translation>
    </message>
    <message>
        <source>the file names %1 groups</source>
        <translation>die Datei nennt %1 Gruppen</translation>
    </message>
    <message>
        <source>connected parts, as the file names no objects or groups</source>
        <translation>zusammenhängende Teile, da die Datei weder Objekte noch Gruppen nennt</translation>
    </message>
    <message>
        <source>stated in the FBX file</source>
        <translation>in der FBX-Datei angegeben</translation>
    </message>
    <message>
        <source>glTF files are in metres</source>
        <translation>glTF-Dateien sind in Metern</translation>
    </message>
    <message>
        <source>y is up in glTF files</source>
        <translation>in glTF-Dateien zeigt y nach oben</translation>
    </message>
    <message>
        <source>Collada files state their up axis; read as y</source>
        <translation>Collada-Dateien nennen ihre Hochachse; als y gelesen</translation>
    </message>
    <message>
        <source>Collada files state their unit; read as metres</source>
        <translation>Collada-Dateien nennen ihre Einheit; als Meter gelesen</translation>
    </message>
    <message>
        <source>largest extent %1, read as metres: %2 mm</source>
        <translation>größte Ausdehnung %1, als Meter gelesen: %2 mm</translation>
    </message>
    <message>
        <source>largest extent %1, read as centimetres: %2 mm</source>
        <translation>größte Ausdehnung %1, als Zentimeter gelesen: %2 mm</translation>
    </message>
    <message>
        <source>largest extent %1, read as millimetres</source>
        <translation>größte Ausdehnung %1, als Millimeter gelesen</translation>
    </message>
    <message>
        <source>no extent, read as millimetres</source>
        <translation>ohne Ausdehnung, als Millimeter gelesen</translation>
    </message>
    <message>
        <source>flattest along y, as a body is from front to back: z is up</source>
        <translation>am flachsten entlang y, wie ein Körper von vorn nach hinten: z zeigt nach oben</translation>
    </message>
    <message>
        <source>flatter along y than along z: z may be up</source>
        <translation>flacher entlang y als entlang z: z könnte nach oben zeigen</translation>
    </message>
    <message>
        <source>the openings lie one above the other along z: z is up</source>
        <translation>die Öffnungen liegen entlang z übereinander: z zeigt nach oben</translation>
    </message>
    <message>
        <source>the openings lie one above the other along y: y is up</source>
        <translation>die Öffnungen liegen entlang y übereinander: y zeigt nach oben</translation>
    </message>
    <message>
        <source>the openings lie as far apart along y as along z: z may be up</source>
        <translation>die Öffnungen liegen entlang y so weit auseinander wie entlang z: z könnte nach oben zeigen</translation>
    </message>
    <message>
        <source>the only opening faces along y: y is up</source>
        <translation>die einzige Öffnung zeigt entlang y: y zeigt nach oben</translation>
    </message>
    <message>
        <source>the only opening faces along z: z may be up</source>
        <translation>die einzige Öffnung zeigt entlang z: z könnte nach oben zeigen</translation>
    </message>
    <message>
        <source>y is up, as in most files</source>
        <translation>y zeigt nach oben, wie in den meisten Dateien</translation>
    </message>
    <message>
        <source>at %1 mm</source>
        <translation>bei %1 mm</translation>
    </message>
    <message>
        <source>%1, the first %2</source>
        <translation>%1, zuerst %2</translation>
    </message>
    <message>
        <source>positions in mm</source>
        <translation>Positionen in mm</translation>
    </message>
    <message>
        <source>%1 mm %2</source>
        <translation>%1 mm %2</translation>
    </message>
    <message>
        <source>%1: %2%3</source>
        <translation>%1: %2%3</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>added</source>
        <translation>hinzugefügt</translation>
    </message>
    <message>
        <source>collapsed</source>
        <translation>zusammengezogen</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>split</source>
        <translation>geteilt</translation>
    </message>
    <message>
        <source>cut apart</source>
        <translation>aufgetrennt</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>, at </source>
        <translation>, bei </translation>
    </message>
    <message>
        <source>, the first at </source>
        <translation>, zuerst bei </translation>
    </message>
    <message>
        <source>%1 welded to another, at %2 mm</source>
        <translation>%1 mit anderen verschmolzen, bei %2 mm</translation>
    </message>
    <message>
        <source>%1 welded to another, the first at %2 mm</source>
        <translation>%1 mit anderen verschmolzen, zuerst bei %2 mm</translation>
    </message>
    <message>
        <source>%1, the longest rim %2 mm</source>
        <translation>%1, der längste Rand %2 mm</translation>
    </message>
    <message>
        <source>%1, its rim %2 mm</source>
        <translation>%1, sein Rand %2 mm</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>no usable face is left</source>
        <translation>keine brauchbare Fläche bleibt übrig</translation>
    </message>
    <message>
        <source>%1 of %2, the worst at %3 mm</source>
        <translation>%1 von %2, das schlimmste bei %3 mm</translation>
    </message>
    <message>
        <source>%1 of %2, at %3 mm</source>
        <translation>%1 von %2, bei %3 mm</translation>
    </message>
    <message>
        <source>Mean strain, %</source>
        <translation>Mittlere Dehnung, %</translation>
    </message>
    <message>
        <source>Seam Δ, %1</source>
        <translation>Naht-Δ, %1</translation>
    </message>
    <message>
        <source>Outline length error, %</source>
        <translation>Längenfehler des Umrisses, %</translation>
    </message>
    <message>
        <source>Area error, %</source>
        <translation>Flächenfehler, %</translation>
    </message>
    <message>
        <source>Flipped triangles</source>
        <translation>Umgeklappte Dreiecke</translation>
    </message>
    <message>
        <source>Outline crossings</source>
        <translation>Kreuzungen des Umrisses</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Zeit, ms</translation>
    </message>
    <message>
        <source>up to %1 mm from the exact outline, not %2 mm</source>
        <translation>bis zu %1 mm vom genauen Umriss statt %2 mm</translation>
    </message>
    <message>
        <source>it would cross itself</source>
        <translation>er würde sich selbst kreuzen</translation>
    </message>
    <message>
        <source>its flat outline would cross itself</source>
        <translation>sein flacher Umriss würde sich selbst kreuzen</translation>
    </message>
    <message>
        <source>the triangle at %1 mm would turn over</source>
        <translation>das Dreieck bei %1 mm würde umklappen</translation>
    </message>
    <message>
        <source>the triangle at %1 mm, all its corners on the outline, would turn over</source>
        <translation>das Dreieck bei %1 mm, dessen Ecken alle am Umriss liegen, würde umklappen</translation>
    </message>
    <message>
        <source>Kinks at the ends of seams</source>
        <translation>Knicke an Nahtenden</translation>
    </message>
    <message>
        <source>the pattern does not fit the page</source>
        <translation>der Schnitt passt nicht auf die Seite</translation>
    </message>
    <message>
        <source>ASTM D6673</source>
        <translation>ASTM D6673</translation>
    </message>
    <message>
        <source>ANSI/AAMA-292</source>
        <translation>ANSI/AAMA-292</translation>
    </message>
    <message>
        <source>Plain drawing</source>
        <translation>Einfache Zeichnung</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>A4 tiles</source>
        <translation>A4-Blätter</translation>
    </message>
    <message>
        <source>Letter tiles</source>
        <translation>Letter-Blätter</translation>
    </message>
    <message>
        <source>Tiles for A4 and Letter</source>
        <translation>Blätter für A4 und Letter</translation>
    </message>
    <message>
        <source>A0</source>
        <translation>A0</translation>
    </message>
    <message>
        <source>Arch D</source>
        <translation>Arch D</translation>
    </message>
    <message>
        <source>Arch E</source>
        <translation>Arch E</translation>
    </message>
    <message>
        <source>Roll, 610 mm</source>
        <translation>Rolle, 610 mm</translation>
    </message>
    <message>
        <source>Roll, 841 mm</source>
        <translation>Rolle, 841 mm</translation>
    </message>
    <message>
        <source>Roll, 914 mm</source>
        <translation>Rolle, 914 mm</translation>
    </message>
    <message>
        <source>Projector</source>
        <translation>Projektor</translation>
    </message>
    <message>
        <source>Inkscape</source>
        <translation>Inkscape</translation>
    </message>
    <message>
        <source>Illustrator</source>
        <translation>Illustrator</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>Laser (LightBurn)</source>
        <translation>Laser (LightBurn)</translation>
    </message>
    <message>
        <source>Cricut</source>
        <translation>Cricut</translation>
    </message>
    <message>
        <source>Layers by kind</source>
        <translation>Ebenen nach Art</translation>
    </message>
    <message>
        <source>Groups by piece</source>
        <translation>Gruppen nach Teil</translation>
    </message>
    <message>
        <source>Exact outlines</source>
        <translation>Genaue Umrisse</translation>
    </message>
    <message>
        <source>CLO, Marvelous Designer</source>
        <translation>CLO, Marvelous Designer</translation>
    </message>
    <message>
        <source>AccuMark</source>
        <translation>AccuMark</translation>
    </message>
    <message>
        <source>Optitex</source>
        <translation>Optitex</translation>
    </message>
    <message>
        <source>Lectra</source>
        <translation>Lectra</translation>
    </message>
    <message>
        <source>Laser cutter</source>
        <translation>Laserschneider</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>ASTM D6673 or ANSI/AAMA-292 for pattern programs, plain for drawing and cutting</source>
        <translation>ASTM D6673 oder ANSI/AAMA-292 für Schnittprogramme, einfach zum Zeichnen und Schneiden</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Rule table</source>
        <translation>Sprungwerttabelle</translation>
    </message>
    <message>
        <source>Control piece</source>
        <translation>Kontrollteil</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>Dots per inch</source>
        <translation>Punkte pro Zoll</translation>
    </message>
    <message>
        <source>Dots per inch of the PNG picture</source>
        <translation>Punkte pro Zoll des PNG-Bildes</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>A file for each piece</source>
        <translation>Eine Datei je Teil</translation>
    </message>
    <message>
        <source>%1 mm x %2 mm; a page can be %3 mm long</source>
        <translation>%1 mm x %2 mm; eine Seite kann %3 mm lang sein</translation>
    </message>
    <message>
        <source>%1 mm x %2 mm, more than %3 pages</source>
        <translation>%1 mm x %2 mm, mehr als %3 Seiten</translation>
    </message>
    <message>
        <source>it has no closed outline</source>
        <translation>es hat keinen geschlossenen Umriss</translation>
    </message>
    <message>
        <source>its outline has no area</source>
        <translation>sein Umriss hat keine Fläche</translation>
    </message>
    <message>
        <source>%1 is left out: %2</source>
        <translation>%1 fehlt: %2</translation>
    </message>
    <message>
        <source>DXF (%1)</source>
        <translation>DXF (%1)</translation>
    </message>
    <message>
        <source>DXF of %1 (%2)</source>
        <translation>DXF von %1 (%2)</translation>
    </message>
    <message>
        <source>%1, but the largest piece would be %2 mm; in %3 it is %4 mm</source>
        <translation>%1, aber das größte Teil hätte %2 mm; in %3 hat es %4 mm</translation>
    </message>
    <message>
        <source>its text says Units: %1</source>
        <translation>sein Text sagt Units: %1</translation>
    </message>
    <message>
        <source>$INSUNITS %1</source>
        <translation>$INSUNITS %1</translation>
    </message>
    <message>
        <source>GarmentCode JSON, %1 of stitched edges</source>
        <translation>GarmentCode-JSON, %1 genähter Kanten</translation>
    </message>
    <message>
        <source>SVG of Toile</source>
        <translation>SVG von Toile</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>the size of its page</source>
        <translation>die Größe der Seite</translation>
    </message>
    <message>
        <source>drawing programs, laser and blade cutters</source>
        <translation>Zeichenprogramme, Laser- und Messerplotter</translation>
    </message>
    <message>
        <source>DXF pattern</source>
        <translation>DXF-Schnitt</translation>
    </message>
    <message>
        <source>pattern programs, CAD and cutting machines</source>
        <translation>Schnittprogramme, CAD und Schneidmaschinen</translation>
    </message>
    <message>
        <source>PDF to print</source>
        <translation>PDF zum Drucken</translation>
    </message>
    <message>
        <source>home printers, copy shops and projectors</source>
        <translation>Drucker zu Hause, Kopierläden und Projektoren</translation>
    </message>
    <message>
        <source>HPGL plot</source>
        <translation>HPGL-Plot</translation>
    </message>
    <message>
        <source>pen plotters and roll cutters</source>
        <translation>Stift- und Schneideplotter</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>OBJ with UV map</source>
        <translation>OBJ mit UV-Abwicklung</translation>
    </message>
    <message>
        <source>3D programs: the garment with its pattern as its texture</source>
        <translation>3D-Programme: das Kleidungsstück mit seinem Schnitt als Textur</translation>
    </message>
    <message>
        <source>USD scene</source>
        <translation>USD-Szene</translation>
    </message>
    <message>
        <source>film and simulation: garment, flat pattern and seams</source>
        <translation>Film und Simulation: Kleidungsstück, flacher Schnitt und Nähte</translation>
    </message>
    <message>
        <source>GLB mesh</source>
        <translation>GLB-Netz</translation>
    </message>
    <message>
        <source>games and web pages: the garment with its pattern as its texture</source>
        <translation>Spiele und Webseiten: das Kleidungsstück mit seinem Schnitt als Textur</translation>
    </message>
    <message>
        <source>GarmentCode pattern</source>
        <translation>GarmentCode-Schnitt</translation>
    </message>
    <message>
        <source>research and simulation: panels, curves and stitches</source>
        <translation>Forschung und Simulation: Teile, Kurven und Nähte</translation>
    </message>
    <message>
        <source>HTML report</source>
        <translation>HTML-Bericht</translation>
    </message>
    <message>
        <source>reading and printing: the drawing with all measures</source>
        <translation>Lesen und Drucken: die Zeichnung mit allen Maßen</translation>
    </message>
    <message>
        <source>CSV tables</source>
        <translation>CSV-Tabellen</translation>
    </message>
    <message>
        <source>spreadsheets: pieces, seams, free edges and the walk along them</source>
        <translation>Tabellenprogramme: Teile, Nähte, offene Kanten und der Weg entlang der Nähte</translation>
    </message>
    <message>
        <source>JSON report</source>
        <translation>JSON-Bericht</translation>
    </message>
    <message>
        <source>scripts: every figure of every piece</source>
        <translation>Skripte: jede Zahl jedes Teils</translation>
    </message>
    <message>
        <source>units_in_meter %1</source>
        <translation>units_in_meter %1</translation>
    </message>
    <message>
        <source>pieces: %1, pages after this one: %2</source>
        <translation>Schnittteile: %1, Seiten nach dieser: %2</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Print at 100 % (actual size),
not fitted to the page.
Measure both squares first.</source>
        <translation>Mit 100 % drucken (Originalgröße),
nicht an die Seite anpassen.
Zuerst beide Quadrate nachmessen.</translation>
    </message>
    <message>
        <source>Cut along the grey frames where pages
meet, and join them by their marks:
the halves make whole diamonds.</source>
        <translation>An den grauen Rahmen schneiden, wo sich
Seiten treffen, und an den Marken zusammen-
setzen: zwei Hälften ergeben eine Raute.</translation>
    </message>
    <message>
        <source>largest extent %1, read as decimetres: %2 mm</source>
        <translation>größte Ausdehnung %1, gelesen als Dezimeter: %2 mm</translation>
    </message>
    <message>
        <source>the piece is left out of the pattern</source>
        <translation>das Schnittteil ist aus dem Schnitt ausgenommen</translation>
    </message>
    <message>
        <source>no cuts were found that open it</source>
        <translation>es wurden keine Einschnitte gefunden, die es öffnen</translation>
    </message>
    <message>
        <source>Export the garment as .obj</source>
        <translation>Exportieren Sie das Kleidungsstück als .obj</translation>
    </message>
    <message>
        <source>; the piece is nearly closed: its outline of %1 mm cannot lie flat around its %2 cm²</source>
        <translation>; das Teil ist fast geschlossen: sein Umriss von %1 mm kann nicht flach um seine %2 cm² liegen</translation>
    </message>
    <message>
        <source>%1 of %2 pieces are smaller than 1 cm²</source>
        <translation>%1 von %2 Teilen sind kleiner als 1 cm²</translation>
    </message>
    <message>
        <source>its cuts are %1 mm long, longer than its outline of %2 mm</source>
        <translation>seine Schnitte sind %1 mm lang, länger als sein Umriss von %2 mm</translation>
    </message>
    <message>
        <source>Cuts longer than the outline</source>
        <translation>Schnitte, die länger sind als der Umriss</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>USD files that state no unit are in cm</source>
        <translation>USD-Dateien ohne Angabe einer Einheit sind in cm</translation>
    </message>
    <message>
        <source>USD files that state no up axis have y up</source>
        <translation>USD-Dateien ohne Angabe der Hochachse haben y nach oben</translation>
    </message>
    <message>
        <source>stated in the USD file</source>
        <translation>in der USD-Datei angegeben</translation>
    </message>
    <message>
        <source>%1 in it is encrypted; unpack it and open the mesh</source>
        <translation>%1 darin ist verschlüsselt; entpacken Sie es und öffnen Sie das Netz</translation>
    </message>
    <message>
        <source>%1 in it cannot be unpacked: %2</source>
        <translation>%1 darin lässt sich nicht entpacken: %2</translation>
    </message>
    <message>
        <source>the archive is damaged</source>
        <translation>das Archiv ist beschädigt</translation>
    </message>
    <message>
        <source>the file looks like a scan</source>
        <translation>die Datei sieht nach einem Scan aus</translation>
    </message>
    <message>
        <source>1 fragment</source>
        <translation>1 Bruchstück</translation>
    </message>
    <message>
        <source>%1 fragments</source>
        <translation>%1 Bruchstücke</translation>
    </message>
    <message>
        <source>a scan of %1</source>
        <translation>ein Scan aus %1</translation>
    </message>
    <message>
        <source>; noise smoothed by %1 mm on average, %2 mm at most</source>
        <translation>; Rauschen geglättet, im Mittel um %1 mm, höchstens um %2 mm</translation>
    </message>
    <message>
        <source>; remeshed to %1 with edges of about %2 mm</source>
        <translation>; neu aufgebaut aus %1 mit Kanten von etwa %2 mm</translation>
    </message>
    <message>
        <source>; it could not be remeshed</source>
        <translation>; die Dreiecke ließen sich nicht neu aufbauen</translation>
    </message>
    <message>
        <source>no two surfaces a thickness apart were found</source>
        <translation>es wurden keine zwei Flächen im Abstand einer Stoffdicke gefunden</translation>
    </message>
    <message>
        <source>%1 beside one large surface</source>
        <translation>%1 neben einer großen Fläche</translation>
    </message>
    <message>
        <source>a closed surface, with nothing inside it</source>
        <translation>eine geschlossene Fläche, in der nichts liegt</translation>
    </message>
    <message>
        <source>surfaces that lie on each other, %1 mm apart</source>
        <translation>Flächen, die im Abstand von %1 mm aufeinanderliegen</translation>
    </message>
    <message>
        <source>two surfaces %1 mm apart</source>
        <translation>zwei Flächen im Abstand von %1 mm</translation>
    </message>
    <message>
        <source>two surfaces %1 to %2 mm apart</source>
        <translation>zwei Flächen im Abstand von %1 bis %2 mm</translation>
    </message>
    <message>
        <source>1 opening</source>
        <translation>1 Öffnung</translation>
    </message>
    <message>
        <source>%1 openings</source>
        <translation>%1 Öffnungen</translation>
    </message>
    <message>
        <source>; %1 left</source>
        <translation>; %1 geblieben</translation>
    </message>
    <message>
        <source>the plane %1 = %2 mm</source>
        <translation>der Ebene %1 = %2 mm</translation>
    </message>
    <message>
        <source>the upright plane through %1 mm</source>
        <translation>der senkrechten Ebene durch %1 mm</translation>
    </message>
    <message>
        <source>Lining</source>
        <translation>Futter</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Lage %1</translation>
    </message>
    <message>
        <source>the mesh has a line there that looks like a seam (%1)</source>
        <translation>im Netz verläuft dort eine Linie, die wie eine Naht aussieht (%1)</translation>
    </message>
    <message>
        <source>its meshes state different units or up axes; unpack it and open those of one garment together</source>
        <translation>seine Netze geben verschiedene Einheiten oder Hochachsen an; entpacken Sie es und öffnen Sie die eines Kleidungsstücks zusammen</translation>
    </message>
    <message>
        <source>where left meets right, %1 mm from symmetric</source>
        <translation>wo links auf rechts trifft, %1 mm von der Symmetrie entfernt</translation>
    </message>
    <message>
        <source>the cloth at its tip is %1 % too long</source>
        <translation>der Stoff an seiner Spitze ist um %1 % zu lang</translation>
    </message>
    <message>
        <source>%1: %2 mm wide, %3 mm long, %4 % used</source>
        <translation>%1: %2 mm breit, %3 mm lang, zu %4 % genutzt</translation>
    </message>
    <message>
        <source>%1: %2, %3 % used</source>
        <translation>%1: %2, zu %3 % genutzt</translation>
    </message>
    <message>
        <source>it has no closed line that could be a hide</source>
        <translation>es enthält keine geschlossene Linie, die eine Haut sein könnte</translation>
    </message>
    <message>
        <source>1 hide</source>
        <translation>1 Haut</translation>
    </message>
    <message>
        <source>%1 hides</source>
        <translation>%1 Häute</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 Bogen</translation>
    </message>
    <message>
        <source>%1 sheets</source>
        <translation>%1 Bögen</translation>
    </message>
    <message>
        <source>on the design, %1 Pa</source>
        <translation>auf dem Entwurf, %1 Pa</translation>
    </message>
    <message>
        <source>on a body, %1 Pa</source>
        <translation>auf einem Körper, %1 Pa</translation>
    </message>
    <message>
        <source>on %1, %2 Pa</source>
        <translation>auf %1, %2 Pa</translation>
    </message>
    <message>
        <source>, gravity</source>
        <translation>, mit Schwerkraft</translation>
    </message>
    <message>
        <source>Far from the design</source>
        <translation>Weit vom Entwurf</translation>
    </message>
    <message>
        <source>the designer&apos;s panels</source>
        <translation>die Teile des Entwerfers</translation>
    </message>
    <message>
        <source>ASTM DXF, read back</source>
        <translation>ASTM-DXF, wieder gelesen</translation>
    </message>
    <message>
        <source>the pattern has no piece %1</source>
        <translation>der Schnitt hat kein Schnittteil %1</translation>
    </message>
    <message>
        <source>%1: the two sides differ by %2 mm more than their ease</source>
        <translation>%1: die beiden Seiten unterscheiden sich um %2 mm mehr als ihre Einhalteweite</translation>
    </message>
    <message>
        <source>%1 is %2 mm longer in the pattern than on the design</source>
        <translation>%1 ist im Schnitt %2 mm länger als auf dem Entwurf</translation>
    </message>
    <message>
        <source>%1 is %2 mm shorter in the pattern than on the design</source>
        <translation>%1 ist im Schnitt %2 mm kürzer als auf dem Entwurf</translation>
    </message>
    <message>
        <source>Wider than the cloth</source>
        <translation>Breiter als der Stoff</translation>
    </message>
    <message>
        <source>the triangle at %1 mm, all its corners on the outline, would have no area left</source>
        <translation>das Dreieck bei %1 mm, dessen Ecken alle am Umriss liegen, hätte keine Fläche mehr</translation>
    </message>
    <message>
        <source>%1, no faces</source>
        <translation>%1, keine Flächen</translation>
    </message>
    <message>
        <source>1 texture coordinate</source>
        <translation>1 Texturkoordinate</translation>
    </message>
    <message>
        <source>%1 texture coordinates</source>
        <translation>%1 Texturkoordinaten</translation>
    </message>
    <message>
        <source>the triangle at %1 mm would have no area left</source>
        <translation>das Dreieck bei %1 mm hätte keine Fläche mehr</translation>
    </message>
    <message>
        <source>not readable</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>with decimal commas; numbers need decimal points</source>
        <translation>mit Dezimalkommas; Zahlen brauchen Dezimalpunkte</translation>
    </message>
    <message>
        <source>left out: fewer than three corners</source>
        <translation>ausgelassen: weniger als drei Ecken</translation>
    </message>
    <message>
        <source>left out: not readable</source>
        <translation>ausgelassen: nicht lesbar</translation>
    </message>
    <message>
        <source>left out: a corner&apos;s index is out of range</source>
        <translation>ausgelassen: der Index einer Ecke liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>without texture coordinate: its index is out of range</source>
        <translation>ohne Texturkoordinate: ihr Index liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>facet %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>record %1</source>
        <translation>Datensatz %1</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>%1 %2, first at %3</source>
        <translation>%1 %2, zuerst bei %3</translation>
    </message>
    <message>
        <source>without finite numbers</source>
        <translation>ohne endliche Zahlen</translation>
    </message>
    <message>
        <source>left out: a corner is repeated</source>
        <translation>ausgelassen: eine Ecke kommt zweimal vor</translation>
    </message>
    <message>
        <source>it has no closed line that could be a piece; export the outlines of its pieces as closed lines</source>
        <translation>es enthält keine geschlossene Linie, die ein Schnittteil sein könnte; exportieren Sie die Umrisse seiner Teile als geschlossene Linien</translation>
    </message>
    <message>
        <source>its outlines, read in %1, are %2 times as long as those of the garment; it is probably in %3 (--pattern-unit %3)</source>
        <translation>seine Umrisse, in %1 gelesen, sind %2-mal so lang wie die des Kleidungsstücks; wahrscheinlich ist es in %3 (--pattern-unit %3)</translation>
    </message>
    <message>
        <source>the border of the sheet is left out: %1 on layer &quot;%2&quot;</source>
        <translation>der Rahmen des Blattes ist ausgelassen: %1 auf Ebene „%2“</translation>
    </message>
    <message>
        <source>%1 more notes like: %2</source>
        <translation>%1 weitere Hinweise wie: %2</translation>
    </message>
    <message>
        <source>it states no code page, so its names are read as Western European and may be wrong; save it with $DWGCODEPAGE or as UTF-8</source>
        <translation>die Datei nennt keine Codepage, daher sind Namen als westeuropäisch gelesen und vielleicht falsch; speichern Sie sie mit $DWGCODEPAGE oder als UTF-8</translation>
    </message>
    <message>
        <source>its code page %1 is unknown, so its names are read as Western European and may be wrong; save it as UTF-8</source>
        <translation>ihre Codepage %1 ist unbekannt, daher sind Namen als westeuropäisch gelesen und vielleicht falsch; speichern Sie sie als UTF-8</translation>
    </message>
    <message>
        <source>Notes on the reference pattern</source>
        <translation>Hinweise zum Referenzschnitt</translation>
    </message>
    <message>
        <source>its point %1 is %2 mm from the nearest piece, %3</source>
        <translation>sein Punkt %1 liegt %2 mm vom nächsten Schnittteil entfernt, %3</translation>
    </message>
    <message>
        <source>in %1 it runs along the outline or another cut, so it opens nothing</source>
        <translation>in %1 läuft er am Umriss oder an einem anderen Einschnitt entlang und öffnet daher nichts</translation>
    </message>
    <message>
        <source>it is %1 mm from the nearest edge of a piece</source>
        <translation>sie liegt %1 mm vom nächsten Rand eines Schnittteils entfernt</translation>
    </message>
    <message>
        <source>more than two edges coincide there, one of them of %1</source>
        <translation>mehr als zwei Kanten fallen dort zusammen, eine davon von %1</translation>
    </message>
    <message>
        <source>the vertices of the two edges there, one of them of %1, do not match one to one</source>
        <translation>die Punkte der beiden Kanten dort, eine davon von %1, passen nicht paarweise zusammen</translation>
    </message>
    <message>
        <source>Check that the folder exists, is writable and has free space</source>
        <translation>Prüfen Sie, ob es den Ordner gibt, ob er beschreibbar ist und Platz hat</translation>
    </message>
    <message>
        <source>Toile does not know the format of the file</source>
        <translation>Toile kennt das Format der Datei nicht</translation>
    </message>
    <message>
        <source>this build of Toile cannot write the format</source>
        <translation>dieses Toile kann das Format nicht schreiben</translation>
    </message>
    <message>
        <source>Use a build with the window</source>
        <translation>Nehmen Sie ein Toile mit Fenster</translation>
    </message>
    <message>
        <source>the file does not match the pattern when read back, so it was not written</source>
        <translation>die Datei stimmt beim Wiederlesen nicht mit dem Schnitt überein und wurde daher nicht geschrieben</translation>
    </message>
    <message>
        <source>Use another format, and report this with the garment</source>
        <translation>Nehmen Sie ein anderes Format, und melden Sie dies mit dem Kleidungsstück</translation>
    </message>
    <message>
        <source>Choose larger paper, or move the pieces closer together</source>
        <translation>Wählen Sie größeres Papier, oder legen Sie die Teile enger</translation>
    </message>
    <message>
        <source>Export it again from the program that made it</source>
        <translation>Exportieren Sie sie noch einmal aus dem Programm, aus dem sie kommt</translation>
    </message>
    <message>
        <source>the file contains no usable geometry</source>
        <translation>die Datei enthält keine brauchbare Geometrie</translation>
    </message>
    <message>
        <source>Open an older copy, or correct this place in a text editor</source>
        <translation>Öffnen Sie eine ältere Kopie, oder berichtigen Sie diese Stelle in einem Texteditor</translation>
    </message>
    <message>
        <source>Update Toile to open it</source>
        <translation>Aktualisieren Sie Toile, um es zu öffnen</translation>
    </message>
    <message>
        <source>the unit is uncertain</source>
        <translation>die Einheit ist unsicher</translation>
    </message>
    <message>
        <source>Set the unit if the size is wrong</source>
        <translation>Geben Sie die Einheit an, wenn die Größe nicht stimmt</translation>
    </message>
    <message>
        <source>faces refer to vertices that do not exist</source>
        <translation>Flächen verweisen auf Punkte, die es nicht gibt</translation>
    </message>
    <message>
        <source>Export the file again if something is missing</source>
        <translation>Exportieren Sie die Datei noch einmal, wenn etwas fehlt</translation>
    </message>
    <message>
        <source>positions are not finite numbers, so their faces are left out</source>
        <translation>Koordinaten sind keine endlichen Zahlen, daher entfallen ihre Flächen</translation>
    </message>
    <message>
        <source>polygons could not be split into triangles cleanly</source>
        <translation>Vielecke ließen sich nicht sauber in Dreiecke zerlegen</translation>
    </message>
    <message>
        <source>Check whether they fold over; if so, triangulate them in the modelling program</source>
        <translation>Prüfen Sie, ob sie sich falten; zerlegen Sie sie dann im Modellierprogramm in Dreiecke</translation>
    </message>
    <message>
        <source>the file has entries that this version does not know</source>
        <translation>die Datei hat Einträge, die diese Fassung nicht kennt</translation>
    </message>
    <message>
        <source>Check their spelling; saving from this version removes them</source>
        <translation>Prüfen Sie ihre Schreibweise; das Speichern mit dieser Fassung entfernt sie</translation>
    </message>
    <message>
        <source>the file has changed since the project was saved</source>
        <translation>die Datei hat sich seit dem Speichern des Projekts geändert</translation>
    </message>
    <message>
        <source>Check that the cuts, eases and positions still fit</source>
        <translation>Prüfen Sie, ob Einschnitte, Einhalteweiten und Lagen noch passen</translation>
    </message>
    <message>
        <source>the garment no longer has this piece, so its settings are not used</source>
        <translation>das Kleidungsstück hat dieses Schnittteil nicht mehr, daher werden seine Einstellungen nicht verwendet</translation>
    </message>
    <message>
        <source>Apply the settings to another piece if you need them</source>
        <translation>Stellen Sie ein anderes Schnittteil so ein, wenn Sie sie brauchen</translation>
    </message>
    <message>
        <source>too many outline edges lie together, so no seams are found there</source>
        <translation>zu viele Kanten von Umrissen liegen beieinander, daher werden dort keine Nähte gefunden</translation>
    </message>
    <message>
        <source>Check the unit, and the mesh at these places</source>
        <translation>Prüfen Sie die Einheit und das Netz an diesen Stellen</translation>
    </message>
    <message>
        <source>the file is not a plain sheet of cloth, so it was converted to one</source>
        <translation>die Datei ist keine einfache Stofffläche und wurde daher in eine umgewandelt</translation>
    </message>
    <message>
        <source>Choose another kind of input if this is wrong</source>
        <translation>Wählen Sie eine andere Art der Eingabe, wenn das nicht stimmt</translation>
    </message>
    <message>
        <source>the file does not fit the chosen kind of input, so it was not converted</source>
        <translation>die Datei passt nicht zur gewählten Art der Eingabe und wurde daher nicht umgewandelt</translation>
    </message>
    <message>
        <source>Choose another kind of input</source>
        <translation>Wählen Sie eine andere Art der Eingabe</translation>
    </message>
    <message>
        <source>Prepare it as a scan to remove debris, close holes and smooth noise</source>
        <translation>Lassen Sie sie als Scan aufbereiten, um Bruchstücke zu entfernen, Löcher zu schließen und Rauschen zu glätten</translation>
    </message>
    <message>
        <source>edges have no length, so their ends are merged</source>
        <translation>Kanten haben keine Länge, daher werden ihre Enden verschmolzen</translation>
    </message>
    <message>
        <source>triangles without area are removed where possible</source>
        <translation>Dreiecke ohne Fläche werden entfernt, wo es geht</translation>
    </message>
    <message>
        <source>duplicate faces are removed</source>
        <translation>doppelte Flächen werden entfernt</translation>
    </message>
    <message>
        <source>faces are flipped to match the larger area around them</source>
        <translation>Flächen werden gewendet, damit sie zur größeren Fläche um sie passen</translation>
    </message>
    <message>
        <source>edges shared by more than two faces are cut apart</source>
        <translation>Kanten von mehr als zwei Flächen werden aufgetrennt</translation>
    </message>
    <message>
        <source>Check that the right faces stay joined there</source>
        <translation>Prüfen Sie, ob dort die richtigen Flächen verbunden bleiben</translation>
    </message>
    <message>
        <source>parts that touch at a single vertex are separated</source>
        <translation>Teile, die sich in einem einzigen Punkt berühren, werden getrennt</translation>
    </message>
    <message>
        <source>different edges join the same two vertices, so vertices are added</source>
        <translation>verschiedene Kanten verbinden dieselben zwei Punkte, daher werden Punkte hinzugefügt</translation>
    </message>
    <message>
        <source>vertices at the same position are merged</source>
        <translation>Punkte an derselben Stelle werden verschmolzen</translation>
    </message>
    <message>
        <source>the piece has holes inside its outline, which stay open</source>
        <translation>das Schnittteil hat Löcher innerhalb seines Umrisses, die offen bleiben</translation>
    </message>
    <message>
        <source>Use the isometric method if the lengths of their rims matter</source>
        <translation>Nehmen Sie die isometrische Methode, wenn es auf die Längen ihrer Ränder ankommt</translation>
    </message>
    <message>
        <source>Add a cut to the piece before you cut cloth</source>
        <translation>Fügen Sie einen Einschnitt hinzu, bevor Sie Stoff zuschneiden</translation>
    </message>
    <message>
        <source>the flat outline crossed itself, so it was moved apart without changing its lengths</source>
        <translation>der flache Umriss kreuzte sich selbst und wurde daher auseinandergeschoben, ohne seine Längen zu ändern</translation>
    </message>
    <message>
        <source>triangles are flipped or have no area in the pattern</source>
        <translation>Dreiecke sind im Schnittmuster umgeklappt oder haben keine Fläche</translation>
    </message>
    <message>
        <source>boundary edges are too short for exact lengths</source>
        <translation>Randkanten sind zu kurz für genaue Längen</translation>
    </message>
    <message>
        <source>Check the piece for doubled vertices and extreme coordinates</source>
        <translation>Prüfen Sie das Schnittteil auf doppelte Punkte und extreme Koordinaten</translation>
    </message>
    <message>
        <source>triangles have almost no height, so the pattern may be uneven there</source>
        <translation>Dreiecke haben fast keine Höhe, daher kann das Schnittmuster dort uneben sein</translation>
    </message>
    <message>
        <source>Merge doubled vertices or remove slivers in the modelling program</source>
        <translation>Verschmelzen Sie doppelte Punkte oder entfernen Sie Splitter im Modellierprogramm</translation>
    </message>
    <message>
        <source>the surface&apos;s curvature needs corners that no flat outline can have</source>
        <translation>die Krümmung der Oberfläche braucht Ecken, die kein flacher Umriss haben kann</translation>
    </message>
    <message>
        <source>the method stopped before it converged</source>
        <translation>das Verfahren hielt an, bevor es konvergierte</translation>
    </message>
    <message>
        <source>Check the strain before you cut cloth; remove slivers, or cut the piece where it curves most</source>
        <translation>Prüfen Sie die Dehnung, bevor Sie Stoff zuschneiden; entfernen Sie Splitter, oder schneiden Sie das Schnittteil dort ein, wo es sich am meisten krümmt</translation>
    </message>
    <message>
        <source>the rims of holes differ in length from the garment</source>
        <translation>die Ränder von Löchern haben eine andere Länge als am Kleidungsstück</translation>
    </message>
    <message>
        <source>Cut from the rim to the outline if you want to sew in a patch</source>
        <translation>Schneiden Sie vom Rand zum Umriss, wenn Sie einen Flicken einnähen wollen</translation>
    </message>
    <message>
        <source>the outline could not be drawn as a fair line, so it is exact</source>
        <translation>der Umriss ließ sich nicht als ausgeglichene Linie zeichnen und ist daher der genaue</translation>
    </message>
    <message>
        <source>Lower the tolerance, remove straight lines and typed intakes, or refine the mesh along the outline</source>
        <translation>Verringern Sie die Toleranz, entfernen Sie gerade Linien und eingegebene Abnäherinhalte, oder verfeinern Sie das Netz am Umriss</translation>
    </message>
    <message>
        <source>the fair line would cross itself, so it stays closer to the exact outline there</source>
        <translation>die ausgeglichene Linie würde sich selbst kreuzen, daher bleibt sie dort näher am genauen Umriss</translation>
    </message>
    <message>
        <source>Cut the piece, or give its edges more room</source>
        <translation>Schneiden Sie das Schnittteil ein, oder geben Sie seinen Kanten mehr Platz</translation>
    </message>
    <message>
        <source>Cut it open along a seam, or let Toile do it</source>
        <translation>Schneiden Sie es entlang einer Naht auf, oder lassen Sie Toile das tun</translation>
    </message>
    <message>
        <source>Cut it from loop to loop, or let Toile do it</source>
        <translation>Schneiden Sie es von Rand zu Rand auf, oder lassen Sie Toile das tun</translation>
    </message>
    <message>
        <source>Cut the handle open along a seam, or let Toile do it</source>
        <translation>Schneiden Sie den Henkel entlang einer Naht auf, oder lassen Sie Toile das tun</translation>
    </message>
    <message>
        <source>parts of the piece touch at a single vertex</source>
        <translation>Teile des Schnittteils berühren sich in einem einzigen Punkt</translation>
    </message>
    <message>
        <source>neighbouring faces point in opposite directions</source>
        <translation>benachbarte Flächen zeigen in entgegengesetzte Richtungen</translation>
    </message>
    <message>
        <source>the piece has only one side, like a Moebius strip</source>
        <translation>das Schnittteil hat nur eine Seite, wie ein Möbiusband</translation>
    </message>
    <message>
        <source>the piece has duplicate faces</source>
        <translation>das Schnittteil hat doppelte Flächen</translation>
    </message>
    <message>
        <source>Remove the duplicate faces in the modelling program</source>
        <translation>Entfernen Sie die doppelten Flächen im Modellierprogramm</translation>
    </message>
    <message>
        <source>the piece does not look like a garment on a body, so it gets the shortest cuts</source>
        <translation>das Schnittteil sieht nicht wie ein Kleidungsstück am Körper aus und bekommt daher die kürzesten Einschnitte</translation>
    </message>
    <message>
        <source>Draw your own cuts if you want them elsewhere</source>
        <translation>Zeichnen Sie eigene Einschnitte, wenn Sie sie anderswo wollen</translation>
    </message>
    <message>
        <source>the seam cannot be removed</source>
        <translation>die Naht lässt sich nicht entfernen</translation>
    </message>
    <message>
        <source>Keep it, or join the parts in the modelling program</source>
        <translation>Behalten Sie sie, oder verbinden Sie die Teile im Modellierprogramm</translation>
    </message>
    <message>
        <source>Check the names in the list of seams</source>
        <translation>Prüfen Sie die Namen in der Liste der Nähte</translation>
    </message>
    <message>
        <source>one boundary edge is as long as all others together, so no flat outline can close</source>
        <translation>eine Randkante ist so lang wie alle anderen zusammen, daher kann sich kein flacher Umriss schließen</translation>
    </message>
    <message>
        <source>Refine the boundary, or move the seam</source>
        <translation>Verfeinern Sie den Rand, oder verlegen Sie die Naht</translation>
    </message>
    <message>
        <source>the solver found no closed outline near the surface&apos;s angles</source>
        <translation>der Löser fand keinen geschlossenen Umriss nahe den Winkeln der Oberfläche</translation>
    </message>
    <message>
        <source>the moved outline cannot be filled without flipped triangles</source>
        <translation>der verschobene Umriss lässt sich nicht ohne umgeklappte Dreiecke füllen</translation>
    </message>
    <message>
        <source>Move the outline less, or refine the mesh along it</source>
        <translation>Verschieben Sie den Umriss weniger, oder verfeinern Sie das Netz an ihm</translation>
    </message>
    <message>
        <source>the equations of the interior could not be solved</source>
        <translation>die Gleichungen des Inneren ließen sich nicht lösen</translation>
    </message>
    <message>
        <source>Check the piece for slivers and extreme differences in edge length</source>
        <translation>Prüfen Sie das Schnittteil auf Splitter und extreme Unterschiede der Kantenlänge</translation>
    </message>
    <message>
        <source>Check the piece for extreme coordinates</source>
        <translation>Prüfen Sie das Schnittteil auf extreme Koordinaten</translation>
    </message>
    <message>
        <source>seams are guessed from edges that lie close together but share no points</source>
        <translation>Nähte sind aus Kanten geraten, die nahe beieinanderliegen, aber keine gemeinsamen Punkte haben</translation>
    </message>
    <message>
        <source>the garment is wrinkled, so its fair lines are less exact than usual</source>
        <translation>das Kleidungsstück hat Falten, daher sind seine ausgeglichenen Linien ungenauer als sonst</translation>
    </message>
    <message>
        <source>Lower the tolerance of fair lines to keep them closer, with more waves</source>
        <translation>Verringern Sie die Toleranz ausgeglichener Linien, damit sie näher bleiben, mit mehr Wellen</translation>
    </message>
    <message>
        <source>the simulation has not settled, so its gap is not reliable</source>
        <translation>die Simulation ist nicht zur Ruhe gekommen, daher ist der Abstand nicht verlässlich</translation>
    </message>
    <message>
        <source>Share of the area that moved to other triangles; 0 if each keeps its share of the garment</source>
        <translation>Anteil der Fläche, der zu anderen Dreiecken gewandert ist; 0, wenn jedes seinen Anteil behält</translation>
    </message>
    <message>
        <source>Largest change in length of an outline edge</source>
        <translation>Größte Längenänderung einer Umrisskante</translation>
    </message>
    <message>
        <source>Number of places where the outline crosses itself</source>
        <translation>Anzahl der Stellen, an denen sich der Umriss selbst kreuzt</translation>
    </message>
    <message>
        <source>Largest difference between the two flat sides of a seam of this piece, beyond the ease</source>
        <translation>Größter Unterschied der beiden flachen Seiten einer Naht dieses Schnittteils, über die Einhalteweite hinaus</translation>
    </message>
    <message>
        <source>Root mean square distance to the panel in the file, after the best fit</source>
        <translation>Quadratisches Mittel des Abstands zum Schnittteil in der Datei, bestmöglich aufeinandergelegt</translation>
    </message>
    <message>
        <source>Stretch or surplus of the cloth, averaged over all mesh edges</source>
        <translation>Dehnung oder Zuviel des Stoffs, im Mittel aller Netzkanten</translation>
    </message>
    <message>
        <source>Largest stretch of a mesh edge from the pattern to the garment</source>
        <translation>Größte Dehnung einer Netzkante vom Schnittmuster zum Kleidungsstück</translation>
    </message>
    <message>
        <source>Largest surplus of a mesh edge from the pattern to the garment</source>
        <translation>Größtes Zuviel einer Netzkante vom Schnittmuster zum Kleidungsstück</translation>
    </message>
    <message>
        <source>a path could not be continued through a triangle</source>
        <translation>ein Weg ließ sich durch ein Dreieck nicht fortsetzen</translation>
    </message>
    <message>
        <source>it crosses itself and earlier cuts so often that a triangle would split into thousands of parts</source>
        <translation>er kreuzt sich selbst und frühere Einschnitte so oft, dass ein Dreieck in Tausende Teile zerfiele</translation>
    </message>
    <message>
        <source>there is no tube to cut around</source>
        <translation>hier ist kein Schlauch, um den er laufen könnte</translation>
    </message>
    <message>
        <source>a dart must start at the rim, but the piece has none</source>
        <translation>ein Abnäher muss am Rand beginnen, aber das Schnittteil hat keinen</translation>
    </message>
    <message>
        <source>; only %1 mm of its edge folds over: smooth the edge there, or remesh a scan</source>
        <translation>; nur %1 mm seiner Kante klappen um: glätten Sie dort die Kante, oder vernetzen Sie einen Scan neu</translation>
    </message>
    <message>
        <source>moving its crossing outline apart adds %1 % strain</source>
        <translation>den sich kreuzenden Umriss auseinanderzurücken kostet %1 % Dehnung</translation>
    </message>
    <message>
        <source>strain exceeds %1 % on %2 % of the area, more than any fabric allows</source>
        <translation>auf %2 % der Fläche liegt die Dehnung über %1 %, mehr als jeder Stoff erlaubt</translation>
    </message>
    <message>
        <source>strain is %1 % on average, which only stretch fabric allows</source>
        <translation>die Dehnung liegt im Mittel bei %1 %, was nur dehnbarer Stoff erlaubt</translation>
    </message>
    <message>
        <source>Correct it in the pattern, then prove again</source>
        <translation>Berichtigen Sie es im Schnitt, und prüfen Sie erneut</translation>
    </message>
    <message>
        <source>the pattern is missing or out of date for %1 of %2 pieces</source>
        <translation>das Schnittmuster fehlt oder ist veraltet für %1 von %2 Schnittteilen</translation>
    </message>
    <message>
        <source>Flatten the garment</source>
        <translation>Wickeln Sie das Kleidungsstück ab</translation>
    </message>
    <message>
        <source>Pieces that could not be flattened</source>
        <translation>Schnittteile, die sich nicht abwickeln ließen</translation>
    </message>
    <message>
        <source>triangles are flipped or have no area in the pattern (%1 of %2)</source>
        <translation>Dreiecke sind im Schnittmuster umgeklappt oder haben keine Fläche (%1 von %2)</translation>
    </message>
    <message>
        <source>Proofs that did not settle</source>
        <translation>Proben, die nicht zur Ruhe kamen</translation>
    </message>
    <message>
        <source>Mirrored pieces</source>
        <translation>Gespiegelte Schnittteile</translation>
    </message>
    <message>
        <source>Swapped pieces</source>
        <translation>Vertauschte Schnittteile</translation>
    </message>
    <message>
        <source>Seams with unequal sides</source>
        <translation>Nähte mit ungleichen Seiten</translation>
    </message>
    <message>
        <source>Seams longer or shorter than the design</source>
        <translation>Nähte, länger oder kürzer als im Entwurf</translation>
    </message>
    <message>
        <source>Pieces missing in the pattern</source>
        <translation>Schnittteile, die im Schnitt fehlen</translation>
    </message>
    <message>
        <source>Pieces that are not in the garment</source>
        <translation>Teile, die das Kleidungsstück nicht hat</translation>
    </message>
    <message>
        <source>Pattern of another garment or unit</source>
        <translation>Schnitt eines anderen Kleidungsstücks oder in anderer Einheit</translation>
    </message>
    <message>
        <source>faces of the garment point inwards (%0), so their pieces come out mirrored</source>
        <translation>Flächen des Kleidungsstücks zeigen nach innen (%0), daher sind ihre Schnittteile gespiegelt</translation>
    </message>
    <message>
        <source>Turn the garment over. If only parts point inwards, make the normals consistent in the modelling program</source>
        <translation>Wenden Sie das Kleidungsstück. Zeigen nur Teile nach innen, gleichen Sie die Normalen im Modellierprogramm an</translation>
    </message>
    <message>
        <source>Strain too high for any fabric</source>
        <translation>Dehnung zu hoch für jeden Stoff</translation>
    </message>
    <message>
        <source>Add cuts or darts where the piece curves most. If the file is a thick shell or a scan, convert it to one sheet first</source>
        <translation>Fügen Sie Einschnitte oder Abnäher hinzu, wo sich das Schnittteil am meisten krümmt. Ist die Datei eine dicke Schale oder ein Scan, wandeln Sie sie zuerst in eine Lage um</translation>
    </message>
    <message>
        <source>Too many tiny pieces</source>
        <translation>Zu viele winzige Schnittteile</translation>
    </message>
    <message>
        <source>Set the unit if the garment is too small. Otherwise leave the tiny pieces out, or split the file by something else. If it is a scan, convert it to one sheet first</source>
        <translation>Geben Sie die Einheit an, wenn das Kleidungsstück zu klein ist. Sonst lassen Sie die winzigen Schnittteile aus, oder teilen Sie die Datei nach etwas anderem. Ist sie ein Scan, wandeln Sie sie zuerst in eine Lage um</translation>
    </message>
    <message>
        <source>Split the garment at its own seams, or draw the cuts yourself. If the file is a thick shell or a scan, convert it to one sheet first</source>
        <translation>Teilen Sie das Kleidungsstück an seinen eigenen Nähten, oder zeichnen Sie die Einschnitte selbst. Ist die Datei eine dicke Schale oder ein Scan, wandeln Sie sie zuerst in eine Lage um</translation>
    </message>
    <message>
        <source>the flat sides of the seam differ by %1 more than the ease (%2 and %3)</source>
        <translation>die flachen Seiten der Naht unterscheiden sich um %1 mehr als die Einhalteweite (%2 und %3)</translation>
    </message>
    <message>
        <source>Choose a method that keeps seam lengths, or set the ease</source>
        <translation>Wählen Sie ein Verfahren, das Nahtlängen hält, oder geben Sie die Einhalteweite an</translation>
    </message>
    <message>
        <source>strain along the warp reaches %1, but the fabric%0 allows %2 (exceeded on %3 of the area)</source>
        <translation>die Dehnung längs der Kette erreicht %1, aber das Material%0 erlaubt %2 (überschritten auf %3 der Fläche)</translation>
    </message>
    <message>
        <source>Turn the grain, choose a fabric with wider limits, or add a dart or a seam there</source>
        <translation>Drehen Sie den Fadenlauf, wählen Sie ein Material mit weiteren Grenzen, oder fügen Sie dort einen Abnäher oder eine Naht hinzu</translation>
    </message>
    <message>
        <source>strain along the weft reaches %1, but the fabric%0 allows %2 (exceeded on %3 of the area)</source>
        <translation>die Dehnung längs des Schusses erreicht %1, aber das Material%0 erlaubt %2 (überschritten auf %3 der Fläche)</translation>
    </message>
    <message>
        <source>strain on the bias reaches %1, but the fabric%0 allows %2 (exceeded on %3 of the area)</source>
        <translation>die Dehnung im Schrägen erreicht %1, aber das Material%0 erlaubt %2 (überschritten auf %3 der Fläche)</translation>
    </message>
    <message>
        <source>the sewn pattern is %1 from the design on average, 95 % within %2; this piece is farthest, %3 on average</source>
        <translation>der genähte Schnitt liegt im Mittel %1 vom Entwurf entfernt, zu 95 % innerhalb von %2; dieses Schnittteil liegt am weitesten weg, im Mittel %3</translation>
    </message>
    <message>
        <source>Show the overlay Gap to see where. Try another method, a dart or a seam there, then prove again</source>
        <translation>Sehen Sie mit der Einfärbung „Abstand“ nach, wo. Versuchen Sie dort ein anderes Verfahren, einen Abnäher oder eine Naht, und prüfen Sie erneut</translation>
    </message>
    <message>
        <source>the outlines that meet at the end of the seam form a corner of %1</source>
        <translation>die Umrisse, die am Nahtende zusammentreffen, bilden eine Ecke von %1</translation>
    </message>
    <message>
        <source>Smooth the corner, or keep it if you want one</source>
        <translation>Gleichen Sie die Ecke aus, oder behalten Sie sie, wenn Sie eine wollen</translation>
    </message>
    <message>
        <source>Pieces that cannot be cut by half</source>
        <translation>Schnittteile, die sich nicht halb zuschneiden lassen</translation>
    </message>
    <message>
        <source>the piece is set to be cut by half, but it has no mirror image, so it is drawn whole</source>
        <translation>das Schnittteil soll halb zugeschnitten werden, hat aber kein Spiegelbild und wird daher ganz gezeichnet</translation>
    </message>
    <message>
        <source>Make mirrored pieces equal, or cut the piece whole</source>
        <translation>Gleichen Sie gespiegelte Schnittteile an, oder schneiden Sie das Schnittteil ganz zu</translation>
    </message>
    <message>
        <source>Facings that do not fit</source>
        <translation>Belege, die nicht passen</translation>
    </message>
    <message>
        <source>no strip of the facing&apos;s width fits along its edge, so the facing is left out</source>
        <translation>entlang der Kante hat kein Streifen von der Breite des Belegs Platz, daher entfällt er</translation>
    </message>
    <message>
        <source>Make the facing narrower, or remove it</source>
        <translation>Machen Sie den Beleg schmaler, oder entfernen Sie ihn</translation>
    </message>
    <message>
        <source>the piece measures %1, but its cloth has room for only %2</source>
        <translation>das Schnittteil misst %1, aber sein Stoff hat nur Platz für %2</translation>
    </message>
    <message>
        <source>Divide the piece by a cut, turn its grain, or use wider cloth</source>
        <translation>Teilen Sie das Schnittteil durch einen Einschnitt, drehen Sie seinen Fadenlauf, oder nehmen Sie breiteren Stoff</translation>
    </message>
    <message>
        <source>Overlapping pieces</source>
        <translation>Überlappende Schnittteile</translation>
    </message>
    <message>
        <source>the pieces overlap on the sheet</source>
        <translation>die Schnittteile überlappen sich auf dem Bogen</translation>
    </message>
    <message>
        <source>the garment&apos;s largest dimension is %1</source>
        <translation>das Kleidungsstück misst höchstens %1</translation>
    </message>
    <message>
        <source>Set the unit of its file</source>
        <translation>Geben Sie die Einheit seiner Datei an</translation>
    </message>
    <message>
        <source>Uncertain unit</source>
        <translation>Einheit unsicher</translation>
    </message>
    <message>
        <source>the file states no unit, and its size is ambiguous (%0)</source>
        <translation>die Datei nennt keine Einheit, und ihre Größe ist nicht eindeutig (%0)</translation>
    </message>
    <message>
        <source>Set the unit, or keep it if the size is right</source>
        <translation>Geben Sie die Einheit an, oder behalten Sie sie, wenn die Größe stimmt</translation>
    </message>
    <message>
        <source>Uncertain up axis</source>
        <translation>Achse nach oben unsicher</translation>
    </message>
    <message>
        <source>the file does not state which axis points up (%0)</source>
        <translation>die Datei gibt nicht an, welche Achse nach oben zeigt (%0)</translation>
    </message>
    <message>
        <source>Set the axis, or keep it if the garment stands upright</source>
        <translation>Geben Sie die Achse an, oder behalten Sie sie, wenn das Kleidungsstück aufrecht steht</translation>
    </message>
    <message>
        <source>no grain is set, so Toile assumes that it runs upwards</source>
        <translation>kein Fadenlauf ist angegeben, daher gilt er als nach oben gerichtet</translation>
    </message>
    <message>
        <source>Turn the grain arrow, or let Toile choose the grain with the least stretch</source>
        <translation>Drehen Sie den Pfeil des Fadenlaufs, oder lassen Sie Toile den Fadenlauf mit der geringsten Dehnung wählen</translation>
    </message>
    <message>
        <source>the piece is a tube with %1 openings and must be cut open to lie flat</source>
        <translation>das Schnittteil ist ein Schlauch mit %1 Öffnungen und muss aufgeschnitten werden, um flach zu liegen</translation>
    </message>
    <message>
        <source>%1, the first at %2 mm in the pattern, where %3 and %4 mm on the piece meet</source>
        <translation>%1, die erste bei %2 mm im Schnitt, wo %3 und %4 mm des Schnittteils aufeinandertreffen</translation>
    </message>
    <message>
        <source>%1 at %2 mm in the pattern, where %3 and %4 mm on the piece meet</source>
        <translation>%1 bei %2 mm im Schnitt, wo %3 und %4 mm des Schnittteils aufeinandertreffen</translation>
    </message>
    <message>
        <source>%1, the worst %2 mm long at %3 mm, off by %4 of its length</source>
        <translation>%1, die schlimmste %2 mm lang bei %3 mm, um %4 ihrer Länge falsch</translation>
    </message>
    <message>
        <source>%1 of %2 mm at %3 mm, off by %4 of its length</source>
        <translation>%1 von %2 mm bei %3 mm, um %4 ihrer Länge falsch</translation>
    </message>
    <message>
        <source>an added face at %1 mm</source>
        <translation>eine eingesetzte Fläche bei %1 mm</translation>
    </message>
    <message>
        <source>an outline edge has a target length of %1 mm</source>
        <translation>eine Kante des Umrisses soll %1 mm lang werden</translation>
    </message>
    <message>
        <source>no solution after %1 steps, gradient %2</source>
        <translation>keine Lösung nach %1 Schritten, Gradient %2</translation>
    </message>
    <message>
        <source>the edge is %1 long, the others together %2</source>
        <translation>die Kante ist %1 lang, die anderen zusammen %2</translation>
    </message>
    <message>
        <source>the outline stays open by %1 of its perimeter</source>
        <translation>der Umriss bleibt um %1 seines Umfangs offen</translation>
    </message>
    <message>
        <source>Toile found no starting shape without flipped triangles</source>
        <translation>es fand sich keine Anfangsform ohne umgeklappte Dreiecke</translation>
    </message>
    <message>
        <source>the strain would be too high</source>
        <translation>die Dehnung wäre zu groß</translation>
    </message>
    <message>
        <source>the angles fit in the plane only to within %1 radians</source>
        <translation>die Winkel passen nur auf %1 rad genau in die Ebene</translation>
    </message>
    <message>
        <source>Pieces overlap on the sheet: %1. Move them apart, or lay out all pieces again.</source>
        <translation>Schnittteile überlappen sich auf dem Bogen: %1. Schieben Sie sie auseinander, oder legen Sie alle neu aus.</translation>
    </message>
    <message>
        <source>Pieces without a grain line because no grain is set: %1. Turn the arrow, or choose a grain.</source>
        <translation>Schnittteile ohne Fadenlauf in der Datei, weil keiner angegeben ist: %1. Drehen Sie den Pfeil, oder wählen Sie einen Fadenlauf.</translation>
    </message>
    <message>
        <source>at a tolerance of %1 mm its curves need more than %2 points; check the unit, and remove lines that belong to no piece</source>
        <translation>auf %1 mm genau brauchen seine Kurven mehr als %2 Punkte; prüfen Sie die Einheit, und entfernen Sie Linien, die zu keinem Schnittteil gehören</translation>
    </message>
    <message>
        <source>%1, so the largest piece is %2 mm</source>
        <translation>%1, damit misst das größte Teil %2 mm</translation>
    </message>
    <message>
        <source>the file states no unit; the largest piece is %1 mm</source>
        <translation>die Datei nennt keine Einheit; das größte Teil misst damit %1 mm</translation>
    </message>
    <message>
        <source>check %1: it has %2, which cover %3 % of it; if they are pieces, remove the line around them from the drawing</source>
        <translation>prüfen Sie %1: es hat %2, zusammen %3 % davon; wenn es Schnittteile sind, entfernen Sie die Linie um sie herum aus der Zeichnung</translation>
    </message>
    <message>
        <source>left out because they are not closed: %1</source>
        <translation>ausgelassen, da nicht geschlossen: %1</translation>
    </message>
    <message>
        <source>left out because they are in no piece or not among the largest %2 outlines: %1</source>
        <translation>ausgelassen, da in keinem Schnittteil oder nicht unter den %2 größten Umrissen: %1</translation>
    </message>
    <message>
        <source>left out because they are on the printed sheet (paper space): %1</source>
        <translation>ausgelassen, da auf dem Druckblatt (Papierbereich): %1</translation>
    </message>
    <message>
        <source>%1: the mirror line is not on the outline, so the piece is not unfolded</source>
        <translation>%1: die Spiegellinie liegt nicht auf dem Umriss, daher wird das Schnittteil nicht aufgeklappt</translation>
    </message>
    <message>
        <source>left out because Toile does not read them: %1</source>
        <translation>ausgelassen, da Toile sie nicht liest: %1</translation>
    </message>
    <message>
        <source>left out because Toile does not use their layers: %1</source>
        <translation>ausgelassen, da Toile ihre Ebenen nicht verwendet: %1</translation>
    </message>
    <message>
        <source>left out because Toile reads each block once: %1</source>
        <translation>ausgelassen, da Toile jeden Block einmal liest: %1</translation>
    </message>
    <message>
        <source>left out because they belong to no piece: %1</source>
        <translation>ausgelassen, da zu keinem Schnittteil gehörig: %1</translation>
    </message>
    <message>
        <source>%1: left out because they are outside its outline: %2</source>
        <translation>%1: ausgelassen, da außerhalb seines Umrisses: %2</translation>
    </message>
    <message>
        <source>%1: %2 in its outlines that are not closed</source>
        <translation>%1: %2 in seinen Umrissen, die nicht geschlossen sind</translation>
    </message>
    <message>
        <source>it states no code page, so it is read as UTF-8; if names are wrong, save it with $DWGCODEPAGE</source>
        <translation>die Datei nennt keine Codepage, daher ist sie als UTF-8 gelesen; wenn Namen falsch sind, speichern Sie sie mit $DWGCODEPAGE</translation>
    </message>
    <message>
        <source>some characters are not in its code page %1; they are shown as �</source>
        <translation>einige Zeichen gehören nicht zu ihrer Codepage %1; sie erscheinen als �</translation>
    </message>
    <message>
        <source>the file states no unit; this format usually uses cm</source>
        <translation>die Datei nennt keine Einheit; dieses Format verwendet meist cm</translation>
    </message>
    <message>
        <source>a closed line that starts outside the hide is left out (layer &quot;%1&quot;)</source>
        <translation>eine geschlossene Linie, die außerhalb der Haut beginnt, ist weggelassen (Ebene „%1“)</translation>
    </message>
    <message>
        <source>its unit is assumed to be %1: %2</source>
        <translation>als Einheit wird %1 angenommen: %2</translation>
    </message>
    <message>
        <source>it states no page size, so 96 units are one inch</source>
        <translation>die Größe der Seite fehlt, daher sind 96 Einheiten ein Zoll</translation>
    </message>
    <message>
        <source>it contains %1, not %2 as its name says</source>
        <translation>sie enthält %1, nicht %2, wie ihre Endung sagt</translation>
    </message>
    <message>
        <source>it does not start like %1</source>
        <translation>sie beginnt nicht wie %1</translation>
    </message>
    <message>
        <source>reading it needs more than %1 s of processor time or %2 MB of memory, too much for %3 MB; it may be damaged, or repeat its meshes too often</source>
        <translation>sie zu lesen braucht mehr als %1 s Rechenzeit oder %2 MB Speicher, zu viel für %3 MB; sie ist vielleicht beschädigt oder wiederholt ihre Netze zu oft</translation>
    </message>
    <message>
        <source>it places %1 objects, too many for its size; export the garment alone, without instances</source>
        <translation>sie setzt %1 Objekte, zu viele für ihre Größe; exportieren Sie das Kleidungsstück allein, ohne Instanzen</translation>
    </message>
    <message>
        <source>it refers to &quot;%1&quot;, which is not in its folder; export it again with its files in the same folder, or as .glb</source>
        <translation>sie verweist auf „%1“, das nicht in ihrem Ordner liegt; exportieren Sie sie neu, mit ihren Dateien daneben oder als .glb</translation>
    </message>
    <message>
        <source>Toile cannot read 3MF files with meshes in separate parts, as slicers save them; export the mesh alone</source>
        <translation>Toile kann 3MF-Dateien mit Netzen in eigenen Teilen, wie Slicer sie speichern, nicht lesen; exportieren Sie das Netz allein</translation>
    </message>
    <message>
        <source>the joints of a skin cannot be found by name; export the mesh without its rig</source>
        <translation>die Gelenke eines Skins sind an ihren Namen nicht zu finden; exportieren Sie das Netz ohne sein Rig</translation>
    </message>
    <message>
        <source>the library that reads this format crashed on it</source>
        <translation>die Bibliothek, die dieses Format liest, ist daran abgestürzt</translation>
    </message>
    <message>
        <source>its buffer &quot;%1&quot; is a folder, pipe or device; put the file itself there</source>
        <translation>ihr Puffer „%1“ ist ein Ordner, eine Pipe oder ein Gerät; legen Sie die Datei selbst dorthin</translation>
    </message>
    <message>
        <source>its buffers up to &quot;%1&quot; are longer than 2 GiB; export fewer or coarser meshes</source>
        <translation>ihre Puffer bis „%1“ sind länger als 2 GiB; exportieren Sie weniger oder gröbere Netze</translation>
    </message>
    <message>
        <source>a comment in the file states a unit of %1, which Toile does not use; set it with --unit</source>
        <translation>ein Kommentar der Datei nennt eine Einheit von %1, die Toile nicht verwendet; setzen Sie sie mit --unit</translation>
    </message>
    <message>
        <source>it is a pattern, not a garment; use it with toile compare --pattern, or open it as the reference pattern</source>
        <translation>es ist ein Schnitt, kein Kleidungsstück; verwenden Sie ihn mit toile compare --pattern, oder öffnen Sie ihn als Referenzschnitt</translation>
    </message>
    <message>
        <source>%1 is binary USD; save it as .usda</source>
        <translation>%1 ist binäres USD; speichern Sie die Datei als .usda</translation>
    </message>
    <message>
        <source>split as a fan: too many corners</source>
        <translation>als Fächer zerlegt: zu viele Ecken</translation>
    </message>
    <message>
        <source>split as a fan: it crosses itself or has no area</source>
        <translation>als Fächer zerlegt: sie kreuzt sich selbst oder hat keine Fläche</translation>
    </message>
    <message>
        <source>it is not USD text</source>
        <translation>es ist kein USD-Text</translation>
    </message>
    <message>
        <source>it has a syntax error</source>
        <translation>sie hat einen Syntaxfehler</translation>
    </message>
    <message>
        <source>the USD file states a unit of %1 m</source>
        <translation>die USD-Datei nennt eine Einheit von %1 m</translation>
    </message>
    <message>
        <source>it contains %1 files; unpack it and open the mesh</source>
        <translation>es enthält %1 Dateien; entpacken Sie es und öffnen Sie das Netz</translation>
    </message>
    <message>
        <source>none of its %1 files ends in %2</source>
        <translation>keine seiner %1 Dateien endet auf %2</translation>
    </message>
    <message>
        <source>it is not a .zip archive: %1</source>
        <translation>es ist kein .zip-Archiv: %1</translation>
    </message>
    <message>
        <source>no seam in this marker is called %1</source>
        <translation>keine Naht in diesem Schnittbild heißt %1</translation>
    </message>
    <message>
        <source>the repeat does not match along %1: its sides are %2 mm off</source>
        <translation>der Rapport passt entlang %1 nicht zusammen: die Seiten weichen um %2 mm ab</translation>
    </message>
    <message>
        <source>the repeat matches at the start of %1, but is %2 mm off at its end</source>
        <translation>der Rapport passt am Anfang von %1, weicht aber am Ende um %2 mm ab</translation>
    </message>
    <message>
        <source>%1 is cut through both layers of the folded cloth, which gives %2 more than needed</source>
        <translation>%1 wird durch beide Lagen des gefalteten Stoffs geschnitten, das sind %2 mehr als gebraucht</translation>
    </message>
    <message>
        <source>%1 is not placed: it is %2 mm across, but the cloth only %3 mm; splice it at %4 mm</source>
        <translation>%1 ist nicht ausgelegt: es ist %2 mm breit, der Stoff nur %3 mm; setzen Sie es bei %4 mm an</translation>
    </message>
    <message>
        <source>%1 is not placed: no room is left; use more cloth</source>
        <translation>%1 ist nicht ausgelegt: es ist kein Platz mehr; nehmen Sie mehr Stoff</translation>
    </message>
    <message>
        <source>%2 copies of %1 are not placed: no room is left; use more cloth</source>
        <translation>%2 Stück von %1 sind nicht ausgelegt: es ist kein Platz mehr; nehmen Sie mehr Stoff</translation>
    </message>
    <message>
        <source>%1 is not placed: it fits on no sheet or hide; divide it by a cut, or use larger ones</source>
        <translation>%1 ist nicht ausgelegt: es passt auf keinen Bogen und keine Haut; teilen Sie es durch einen Einschnitt, oder nehmen Sie größere</translation>
    </message>
    <message>
        <source>%1 is not placed: its outline crosses itself; divide it by a cut</source>
        <translation>%1 ist nicht ausgelegt: sein Umriss kreuzt sich selbst; teilen Sie es durch einen Einschnitt</translation>
    </message>
    <message>
        <source>kept because their neighbours are flat too</source>
        <translation>behalten, da die Nachbarn auch flach sind</translation>
    </message>
    <message>
        <source>removed at the boundary</source>
        <translation>am Rand entfernt</translation>
    </message>
    <message>
        <source>removed in pairs</source>
        <translation>paarweise entfernt</translation>
    </message>
    <message>
        <source>merged into the neighbour</source>
        <translation>mit dem Nachbarn vereinigt</translation>
    </message>
    <message>
        <source>removed with all around them</source>
        <translation>mit allem ringsum entfernt</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>gewendet</translation>
    </message>
    <message>
        <source>its outline is not a polygon</source>
        <translation>sein Umriss ist kein Polygon</translation>
    </message>
    <message>
        <source>its outline winds around twice, or a hole is outside it or overlaps another</source>
        <translation>sein Umriss läuft zweimal herum, oder ein Loch liegt außerhalb oder überlappt ein anderes</translation>
    </message>
    <message>
        <source>its copies or angles are not valid numbers</source>
        <translation>seine Anzahl oder seine Winkel sind keine gültigen Zahlen</translation>
    </message>
    <message>
        <source>no room is left for it on the cloth</source>
        <translation>auf dem Stoff ist kein Platz mehr dafür</translation>
    </message>
    <message>
        <source>it does not fit across a strip of %1 mm at any allowed angle</source>
        <translation>es passt in keinem erlaubten Winkel in einen Streifen von %1 mm</translation>
    </message>
    <message>
        <source>it is longer than the cloth at every allowed angle</source>
        <translation>es ist in jedem erlaubten Winkel länger als der Stoff</translation>
    </message>
    <message>
        <source>the gap and border leave no room on this width</source>
        <translation>Abstand und Rand lassen auf dieser Breite keinen Platz</translation>
    </message>
    <message>
        <source>a marker holds at most %1 copies; make several markers, or use fewer copies</source>
        <translation>ein Schnittbild fasst höchstens %1 Stücke; machen Sie mehrere Schnittbilder, oder nehmen Sie weniger Stücke</translation>
    </message>
    <message>
        <source>its fixed place is outside the cloth</source>
        <translation>sein fester Platz liegt außerhalb des Stoffs</translation>
    </message>
    <message>
        <source>its fixed place overlaps %1</source>
        <translation>sein fester Platz überlappt %1</translation>
    </message>
    <message>
        <source>an excluded band ends before it begins</source>
        <translation>ein ausgeschlossener Abschnitt endet vor seinem Anfang</translation>
    </message>
    <message>
        <source>half a garment needs rims in an upright plane with all cloth on one side, and there is no such plane; check which axis points up</source>
        <translation>ein halbes Kleidungsstück braucht Ränder in einer senkrechten Ebene mit allem Stoff auf einer Seite, und eine solche Ebene gibt es nicht; prüfen Sie, welche Achse nach oben zeigt</translation>
    </message>
    <message>
        <source>half a garment: the mirror image of its %1 is added and joined along %2 mm in %3</source>
        <translation>ein halbes Kleidungsstück: Zu %1 ist das Spiegelbild hinzugefügt und auf %2 mm in %3 verbunden</translation>
    </message>
    <message>
        <source>the openings lie beside each other along x: y or z may be up</source>
        <translation>die Öffnungen liegen entlang x nebeneinander: y oder z könnte nach oben zeigen</translation>
    </message>
    <message>
        <source>an open sheet does not show its right side, so the winding of its faces decides</source>
        <translation>eine offene Lage zeigt ihre rechte Seite nicht, daher entscheidet der Umlaufsinn ihrer Flächen</translation>
    </message>
    <message>
        <source>%1 % of the cloth around an inside points inwards</source>
        <translation>%1 % des Stoffs um eine Innenseite zeigen nach innen</translation>
    </message>
    <message>
        <source>%1 % of the cloth around an inside points outwards</source>
        <translation>%1 % des Stoffs um eine Innenseite zeigen nach außen</translation>
    </message>
    <message>
        <source>a thick shell, %1: the outer surface is used; %2 of the inner one and %3 of rims are left out</source>
        <translation>eine dicke Schale, %1: Die äußere Fläche wird verwendet; weggelassen: %2 der inneren, %3 der Ränder</translation>
    </message>
    <message>
        <source>a thick shell, %1: the inner surface is used; %2 of the outer one and %3 of rims are left out</source>
        <translation>eine dicke Schale, %1: Die innere Fläche wird verwendet; weggelassen: %2 der äußeren, %3 der Ränder</translation>
    </message>
    <message>
        <source>a thick shell, %1: the middle between its surfaces is used; %2 of the inner surface and %3 of rims are left out</source>
        <translation>eine dicke Schale, %1: Die Mitte zwischen den Flächen wird verwendet; weggelassen: %2 der inneren Fläche, %3 der Ränder</translation>
    </message>
    <message>
        <source>there is no layer %1 among the %2 layers, so all are used</source>
        <translation>es gibt keine Lage %1 unter den %2 Lagen, daher werden alle verwendet</translation>
    </message>
    <message>
        <source>%1 layers of cloth, %2 mm apart: layer %3 from outside is used, with %4; %5 of the others are left out</source>
        <translation>%1 Stofflagen, %2 mm auseinander: Die Lage %3 von außen wird verwendet, mit %4; weggelassen: %5 der anderen</translation>
    </message>
    <message>
        <source>no connected part lies inside another; layers that share vertices are one part</source>
        <translation>kein zusammenhängendes Stück liegt in einem anderen; Lagen mit gemeinsamen Eckpunkten sind ein Stück</translation>
    </message>
    <message>
        <source>; %1 of %2 cm² removed</source>
        <translation>; %1 mit %2 cm² entfernt</translation>
    </message>
    <message>
        <source>; %1 closed with %2 cm²</source>
        <translation>; %1 mit %2 cm² geschlossen</translation>
    </message>
    <message>
        <source>; it is not a clean surface, so holes and noise are not treated</source>
        <translation>; sie ist keine saubere Fläche, daher bleiben Löcher und Rauschen, wie sie sind</translation>
    </message>
    <message>
        <source>%1, not joined by a rim</source>
        <translation>%1, die kein Rand verbindet</translation>
    </message>
    <message>
        <source>it is far from the garment; check its unit and its axes</source>
        <translation>er liegt weit vom Kleidungsstück entfernt; prüfen Sie seine Einheit und seine Achsen</translation>
    </message>
    <message>
        <source>the cloth ended %1 mm from the design on average, on a design of %2 mm; check that pattern and unit belong to this garment</source>
        <translation>der Stoff liegt am Ende im Mittel %1 mm vom Entwurf entfernt, der %2 mm groß ist; prüfen Sie, ob Schnitt und Einheit zu diesem Kleidungsstück gehören</translation>
    </message>
    <message>
        <source>its outlines, read in %1, are %2 times as long as those of the garment; set its unit, or that of the garment</source>
        <translation>seine Umrisse, in %1 gelesen, sind %2-mal so lang wie die des Kleidungsstücks; geben Sie seine Einheit oder die des Kleidungsstücks an</translation>
    </message>
    <message>
        <source>no piece of the pattern is a flat piece of the garment; use a pattern made from this garment</source>
        <translation>kein Teil des Schnitts ist ein flaches Schnittteil des Kleidungsstücks; nehmen Sie einen Schnitt, der aus diesem Kleidungsstück gemacht ist</translation>
    </message>
    <message>
        <source>its pattern is too small to be written to a file; set the unit of the garment</source>
        <translation>sein Schnitt ist zu klein, um in eine Datei geschrieben zu werden; geben Sie die Einheit des Kleidungsstücks an</translation>
    </message>
    <message>
        <source>edges of %1 mm make %2 triangles, too many to sew; use edges of %3 mm or more</source>
        <translation>Kanten von %1 mm ergeben %2 Dreiecke, zu viele zum Nähen; nehmen Sie Kanten von %3 mm oder mehr</translation>
    </message>
    <message>
        <source>the outline of %1 crosses itself in the pattern, so the piece is left out</source>
        <translation>der Umriss von %1 kreuzt sich im Schnitt selbst, daher ist das Teil ausgelassen</translation>
    </message>
    <message>
        <source>the sides of %1 are sewn to each other, so nothing of it is left</source>
        <translation>die Seiten von %1 sind aneinandergenäht, sodass nichts davon bleibt</translation>
    </message>
    <message>
        <source>the garment has no piece for %1 of the pattern</source>
        <translation>das Kleidungsstück hat kein Schnittteil zu %1 im Schnitt</translation>
    </message>
    <message>
        <source>%1 is mirrored in the pattern and is turned over for sewing</source>
        <translation>%1 ist im Schnitt gespiegelt und wird zum Nähen gewendet</translation>
    </message>
    <message>
        <source>%1 of the pattern does not fit %2, but %3</source>
        <translation>%1 im Schnitt passt nicht zu %2, sondern zu %3</translation>
    </message>
    <message>
        <source>%1: the side of %2 is %3 mm longer than the other side</source>
        <translation>%1: die Seite von %2 ist %3 mm länger als die andere Seite</translation>
    </message>
    <message>
        <source>. Tightest seam: %1, %2 %, more than the fabric allows</source>
        <translation>. Straffste Naht: %1, %2 %, mehr als der Stoff erlaubt</translation>
    </message>
    <message>
        <source>. Tightest piece: %1, %2 %, more than the fabric allows</source>
        <translation>. Straffstes Schnittteil: %1, %2 %, mehr als der Stoff erlaubt</translation>
    </message>
    <message>
        <source>. Tightest seam: %1, %2 %, which the fabric allows</source>
        <translation>. Straffste Naht: %1, %2 %, was der Stoff erlaubt</translation>
    </message>
    <message>
        <source>. Tightest piece: %1, %2 %, which the fabric allows</source>
        <translation>. Straffstes Schnittteil: %1, %2 %, was der Stoff erlaubt</translation>
    </message>
    <message>
        <source>. Tightest seam: %1, %2 %</source>
        <translation>. Straffste Naht: %1, %2 %</translation>
    </message>
    <message>
        <source>. Tightest piece: %1, %2 %</source>
        <translation>. Straffstes Schnittteil: %1, %2 %</translation>
    </message>
    <message>
        <source>. Loosest piece: %1, %2 % slack</source>
        <translation>. Lockerstes Schnittteil: %1, %2 % Zuviel</translation>
    </message>
    <message>
        <source>The sewn pattern is %1 mm from the design on average, 95 % within %2 mm</source>
        <translation>Der genähte Schnitt liegt im Mittel %1 mm vom Entwurf entfernt, zu 95 % innerhalb von %2 mm</translation>
    </message>
    <message>
        <source>. %1 % hangs free</source>
        <translation>. %1 % hängen frei</translation>
    </message>
    <message>
        <source>. %1 of %2 pieces are missing</source>
        <translation>. %1 von %2 Teilen fehlen</translation>
    </message>
    <message>
        <source>, %1 mm between layers</source>
        <translation>, %1 mm zwischen den Lagen</translation>
    </message>
    <message>
        <source>, scaled by %1</source>
        <translation>, um %1 skaliert</translation>
    </message>
    <message>
        <source>, own stiffness values</source>
        <translation>, eigene Steifigkeitswerte</translation>
    </message>
    <message>
        <source>the seams file sets its ease</source>
        <translation>die Nahtdatei setzt ihre Einhalteweite</translation>
    </message>
    <message>
        <source>a border in the file&apos;s UV map or parts</source>
        <translation>eine Grenze in der UV-Karte oder den Teilen der Datei</translation>
    </message>
    <message>
        <source>from the shape</source>
        <translation>nach der Form</translation>
    </message>
    <message>
        <source>along a ridge of the shape</source>
        <translation>entlang einer Kante der Form</translation>
    </message>
    <message>
        <source>the shortest cut that lets the piece lie flat</source>
        <translation>der kürzeste Einschnitt, mit dem das Teil flach liegt</translation>
    </message>
    <message>
        <source>splitting by %1 gives %2 pieces, more than the limit of %3; split it by something else, or join its parts in the modelling program</source>
        <translation>die Teilung nach „%1“ ergibt %2 Schnittteile, mehr als die Grenze von %3; teilen Sie sie nach etwas anderem, oder verbinden Sie ihre Teile im Modellierprogramm</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>In einer Richtung</translation>
    </message>
    <message>
        <source>Repeat a&amp;long</source>
        <translation>Rapport &amp;längs</translation>
    </message>
    <message>
        <source>Repeat along the warp</source>
        <translation>Rapport längs der Kette</translation>
    </message>
    <message>
        <source>Distance of stripes along the warp; 0: no stripes</source>
        <translation>Abstand der Streifen längs der Kette; 0: keine Streifen</translation>
    </message>
    <message>
        <source>Repeat acro&amp;ss</source>
        <translation>Rapport q&amp;uer</translation>
    </message>
    <message>
        <source>Repeat across the warp</source>
        <translation>Rapport quer zur Kette</translation>
    </message>
    <message>
        <source>Distance of stripes across the warp; 0: no stripes</source>
        <translation>Abstand der Streifen quer zur Kette; 0: keine Streifen</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>Width of the marker</source>
        <translation>Breite des Schnittbilds</translation>
    </message>
    <message>
        <source>Ga&amp;p</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>Gap of the marker</source>
        <translation>Abstand im Schnittbild</translation>
    </message>
    <message>
        <source>Smallest distance between two pieces</source>
        <translation>Kleinster Abstand zwischen zwei Teilen</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Rand</translation>
    </message>
    <message>
        <source>Border of the marker</source>
        <translation>Rand des Schnittbilds</translation>
    </message>
    <message>
        <source>Grain tol&amp;erance</source>
        <translation>Fad&amp;enlauf-Toleranz</translation>
    </message>
    <message>
        <source>Grain tolerance</source>
        <translation>Fadenlauf-Toleranz</translation>
    </message>
    <message>
        <source>F&amp;olded lengthwise</source>
        <translation>Der Länge nach ge&amp;faltet</translation>
    </message>
    <message>
        <source>Folded cloth</source>
        <translation>Gefalteter Stoff</translation>
    </message>
    <message>
        <source>Two layers, right sides together: pairs are cut at once, and symmetric pieces on the fold</source>
        <translation>Zwei Lagen, rechts auf rechts: Paare werden auf einmal zugeschnitten, symmetrische Teile im Bruch</translation>
    </message>
    <message>
        <source>&amp;Garments</source>
        <translation>Kleidun&amp;gsstücke</translation>
    </message>
    <message>
        <source>Garments of the marker</source>
        <translation>Kleidungsstücke des Schnittbilds</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Einschnitt</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Castle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Over the first leg</source>
        <translation>Über den ersten Schenkel</translation>
    </message>
    <message>
        <source>Over the second leg</source>
        <translation>Über den zweiten Schenkel</translation>
    </message>
    <message>
        <source>Mitred</source>
        <translation>Auf Gehrung</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Stumpf</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>Abgestuft</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>&amp;Toleranz</translation>
    </message>
    <message>
        <source>Tolerance of fair lines</source>
        <translation>Toleranz der ausgeglichenen Linien</translation>
    </message>
    <message>
        <source>Smoot&amp;hing length</source>
        <translation>&amp;Glättungslänge</translation>
    </message>
    <message>
        <source>Smoothing length</source>
        <translation>Glättungslänge</translation>
    </message>
    <message>
        <source>Larger values smooth longer waves</source>
        <translation>Größere Werte glätten längere Wellen</translation>
    </message>
    <message>
        <source>Len&amp;gth</source>
        <translation>L&amp;änge</translation>
    </message>
    <message>
        <source>Length of a segment</source>
        <translation>Länge eines Abschnitts</translation>
    </message>
    <message>
        <source>Length in the pattern, on both sides of a seam</source>
        <translation>Länge im Schnittmuster, auf beiden Seiten einer Naht</translation>
    </message>
    <message>
        <source>3D length</source>
        <translation>3D-Länge</translation>
    </message>
    <message>
        <source>T&amp;olerance</source>
        <translation>T&amp;oleranz</translation>
    </message>
    <message>
        <source>Tolerance of a segment</source>
        <translation>Toleranz eines Abschnitts</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Gerade Linie</translation>
    </message>
    <message>
        <source>Straight segment</source>
        <translation>Abschnitt als gerade Linie</translation>
    </message>
    <message>
        <source>Allo&amp;wance</source>
        <translation>&amp;Zugabe</translation>
    </message>
    <message>
        <source>Allowance of a segment</source>
        <translation>Zugabe eines Abschnitts</translation>
    </message>
    <message>
        <source>Width of the cloth beyond the line</source>
        <translation>Breite des Stoffs außerhalb der Linie</translation>
    </message>
    <message>
        <source>Corner at its &amp;start</source>
        <translation>Ecke am An&amp;fang</translation>
    </message>
    <message>
        <source>Corner of an allowance</source>
        <translation>Ecke einer Zugabe</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>E&amp;xtension</source>
        <translation>Verlän&amp;gerung</translation>
    </message>
    <message>
        <source>Extension of an edge</source>
        <translation>Verlängerung einer Kante</translation>
    </message>
    <message>
        <source>Extend a free edge in parallel by this width, for a button stand or a turn-up</source>
        <translation>Eine freie Kante parallel um diese Breite verlängern, für eine Knopfleiste oder einen Umschlag</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Width of seam allowances</source>
        <translation>Breite der Nahtzugaben</translation>
    </message>
    <message>
        <source>Hems</source>
        <translation>Säume</translation>
    </message>
    <message>
        <source>Width of hems</source>
        <translation>Breite der Saumzugaben</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Form of notches</source>
        <translation>Form der Knipse</translation>
    </message>
    <message>
        <source>How a notch is cut or drawn</source>
        <translation>Wie ein Knips geschnitten oder gezeichnet wird</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Tiefe der Knipse</translation>
    </message>
    <message>
        <source>&amp;Intake</source>
        <translation>&amp;Inhalt</translation>
    </message>
    <message>
        <source>Intake of a dart</source>
        <translation>Abnäherinhalt</translation>
    </message>
    <message>
        <source>As flattened</source>
        <translation>Wie abgewickelt</translation>
    </message>
    <message>
        <source>Fol&amp;d</source>
        <translation>G&amp;elegt</translation>
    </message>
    <message>
        <source>Fold of a dart</source>
        <translation>Lage eines Abnähers</translation>
    </message>
    <message>
        <source>By convention</source>
        <translation>Wie üblich</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Grö&amp;ße</translation>
    </message>
    <message>
        <source>Size on labels</source>
        <translation>Größe auf den Schnittteilen</translation>
    </message>
    <message>
        <source>&amp;Date</source>
        <translation>&amp;Datum</translation>
    </message>
    <message>
        <source>Date on labels</source>
        <translation>Datum auf den Schnittteilen</translation>
    </message>
    <message>
        <source>&amp;Fair lines</source>
        <translation>&amp;Linien ausgleichen</translation>
    </message>
    <message>
        <source>Fair lines</source>
        <translation>Linien ausgleichen</translation>
    </message>
    <message>
        <source>Draw every line as a smooth curve of the same length, near the exact outline</source>
        <translation>Jede Linie als glatte Kurve derselben Länge zeichnen, nahe am genauen Umriss</translation>
    </message>
    <message>
        <source>S&amp;mooth corners up to</source>
        <translation>Knicke a&amp;usgleichen bis</translation>
    </message>
    <message>
        <source>Smooth corners at seams</source>
        <translation>Knicke an Nahtenden ausgleichen</translation>
    </message>
    <message>
        <source>Seam &amp;allowance</source>
        <translation>N&amp;ahtzugabe</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Nahtzugabe</translation>
    </message>
    <message>
        <source>&amp;Notches</source>
        <translation>&amp;Knipse</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Knipse</translation>
    </message>
    <message>
        <source>Drop &amp;debris</source>
        <translation>&amp;Bruchstücke entfernen</translation>
    </message>
    <message>
        <source>Drop debris</source>
        <translation>Bruchstücke entfernen</translation>
    </message>
    <message>
        <source>Close &amp;holes with a perimeter up to</source>
        <translation>&amp;Löcher schließen bis zu einem Umfang von</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Löcher schließen</translation>
    </message>
    <message>
        <source>&amp;Smooth noise by at most</source>
        <translation>&amp;Rauschen glätten um höchstens</translation>
    </message>
    <message>
        <source>Smooth noise</source>
        <translation>Rauschen glätten</translation>
    </message>
    <message>
        <source>&amp;Remesh with edges of</source>
        <translation>&amp;Dreiecke neu bilden mit Kanten von</translation>
    </message>
    <message>
        <source>Edge length of the mesh</source>
        <translation>Kantenlänge des Netzes</translation>
    </message>
    <message>
        <source>This pattern</source>
        <translation>Dieser Schnitt</translation>
    </message>
    <message>
        <source>The designer&apos;s panels</source>
        <translation>Die Teile des Entwerfers</translation>
    </message>
    <message>
        <source>The reference pattern</source>
        <translation>Der Vergleichsschnitt</translation>
    </message>
    <message>
        <source>N/m</source>
        <translation>N/m</translation>
    </message>
    <message>
        <source>Stretch, warp</source>
        <translation>Zug, Kette</translation>
    </message>
    <message>
        <source>Stretch stiffness along the warp</source>
        <translation>Zugsteifigkeit längs der Kette</translation>
    </message>
    <message>
        <source>Stretch, weft</source>
        <translation>Zug, Schuss</translation>
    </message>
    <message>
        <source>Stretch stiffness along the weft</source>
        <translation>Zugsteifigkeit längs des Schusses</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Schub</translation>
    </message>
    <message>
        <source>Shear stiffness</source>
        <translation>Schubsteifigkeit</translation>
    </message>
    <message>
        <source>Resistance to shear, as when the cloth is pulled on the bias</source>
        <translation>Widerstand gegen Schub, etwa bei Zug im schrägen Fadenlauf</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>Bending stiffness</source>
        <translation>Biegesteifigkeit</translation>
    </message>
    <message>
        <source>Resistance to bending</source>
        <translation>Widerstand gegen Biegung</translation>
    </message>
    <message>
        <source>µN·m</source>
        <translation>µN·m</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Weight of the cloth</source>
        <translation>Gewicht des Stoffs</translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation>g/m²</translation>
    </message>
    <message>
        <source>Pattern to test</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Pattern of the proof</source>
        <translation>Schnitt der Nähprobe</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Triangles of the proof</source>
        <translation>Dreiecke der Nähprobe</translation>
    </message>
    <message>
        <source>As in the garment</source>
        <translation>Wie im Kleidungsstück</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Pressure of the proof</source>
        <translation>Druck der Nähprobe</translation>
    </message>
    <message>
        <source>Pa</source>
        <translation>Pa</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Proof with gravity</source>
        <translation>Nähprobe mit Schwerkraft</translation>
    </message>
    <message>
        <source>Cloth touches itself</source>
        <translation>Stoff berührt sich selbst</translation>
    </message>
    <message>
        <source>Proof with layers that touch</source>
        <translation>Nähprobe mit Lagen, die sich berühren</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness of the cloth</source>
        <translation>Dicke des Stoffs</translation>
    </message>
    <message>
        <source>Distance between layers of cloth</source>
        <translation>Abstand zwischen Lagen von Stoff</translation>
    </message>
    <message>
        <source>Garment&apos;s fabric</source>
        <translation>Stoff des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Unexpected error (%1). Please report it with the garment file.</source>
        <translation>Unerwarteter Fehler (%1). Bitte melden Sie ihn mit der Datei des Kleidungsstücks.</translation>
    </message>
    <message>
        <source>Time of the last solve of this piece</source>
        <translation>Rechenzeit der letzten Abwicklung dieses Schnittteils</translation>
    </message>
    <message>
        <source>Triangles whose orientation is reversed in the pattern; cloth cannot do that</source>
        <translation>Dreiecke, die im Schnittmuster umgeklappt sind; Stoff kann das nicht</translation>
    </message>
    <message>
        <source>Distance to reference panel, %1</source>
        <translation>Abstand zum Referenzteil, %1</translation>
    </message>
    <message>
        <source>Max. stretch, %</source>
        <translation>Größte Dehnung, %</translation>
    </message>
    <message>
        <source>Max. surplus, %</source>
        <translation>Größter Überschuss, %</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Drawn pattern</source>
        <translation>Gezeichneter Schnitt</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Program that opens the DXF file; sets profile and unit</source>
        <translation>Programm, das die DXF-Datei öffnet; legt Profil und Einheit fest</translation>
    </message>
    <message>
        <source>Unit of the numbers in the DXF file</source>
        <translation>Einheit der Zahlen in der DXF-Datei</translation>
    </message>
    <message>
        <source>Also write a rule table of one size (.rul)</source>
        <translation>Auch eine Sprungwerttabelle mit einer Größe (.rul) schreiben</translation>
    </message>
    <message>
        <source>Add a square of 100 mm as an extra piece, to check the scale</source>
        <translation>Ein Quadrat von 100 mm als zusätzliches Teil, um den Maßstab zu prüfen</translation>
    </message>
    <message>
        <source>Paper of the PDF file: tiles of a4, letter or tile, which fits both; one page of a0, arch-d or arch-e; a roll; or projector</source>
        <translation>Papier der PDF-Datei: Blätter in a4, letter oder tile, das auf beide passt; ein Bogen a0, arch-d oder arch-e; eine Rolle; oder projector</translation>
    </message>
    <message>
        <source>Overlap of the tiles of a PDF file, mm</source>
        <translation>Überlappung der Blätter einer PDF-Datei, mm</translation>
    </message>
    <message>
        <source>Program or machine that opens the SVG file</source>
        <translation>Programm oder Maschine, die die SVG-Datei öffnet</translation>
    </message>
    <message>
        <source>A layer for each kind of line, or a group for each piece</source>
        <translation>Eine Ebene je Linienart oder eine Gruppe je Schnittteil</translation>
    </message>
    <message>
        <source>Write text as text, or as outlines of its letters</source>
        <translation>Text als Text schreiben oder als Umrisse seiner Buchstaben</translation>
    </message>
    <message>
        <source>Turn the plot by 90°</source>
        <translation>Den Plot um 90° drehen</translation>
    </message>
    <message>
        <source>Texture coordinates of OBJ, USD and GLB files: the drawn pattern, or exact outlines</source>
        <translation>Texturkoordinaten von OBJ-, USD- und GLB-Dateien: der gezeichnete Schnitt oder genaue Umrisse</translation>
    </message>
    <message>
        <source>Also write each piece to its own OBJ file</source>
        <translation>Auch jedes Schnittteil in eine eigene OBJ-Datei schreiben</translation>
    </message>
    <message>
        <source>e-mail and web pages, at a chosen resolution</source>
        <translation>E-Mails und Webseiten, mit gewählter Auflösung</translation>
    </message>
    <message>
        <source>Both ways</source>
        <translation>Beide Richtungen</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>From selvedge to selvedge; default: width of the fabric</source>
        <translation>Von Webkante zu Webkante; Vorgabe: Breite des Stoffs</translation>
    </message>
    <message>
        <source>Smallest distance to the edges of the cloth</source>
        <translation>Kleinster Abstand zu den Kanten des Stoffs</translation>
    </message>
    <message>
        <source>Direc&amp;tion</source>
        <translation>Ri&amp;chtung</translation>
    </message>
    <message>
        <source>Direction of pieces</source>
        <translation>Richtung der Teile</translation>
    </message>
    <message>
        <source>Both ways along the warp, one way for nap and directional prints, or free on cloth without a grain</source>
        <translation>In beiden Richtungen längs der Kette, in einer Richtung bei Strich und gerichteten Mustern, oder frei auf Stoff ohne Fadenlauf</translation>
    </message>
    <message>
        <source>Maximum rotation of a piece off the grain, to both sides</source>
        <translation>Größte Drehung eines Teils gegen den Fadenlauf, nach beiden Seiten</translation>
    </message>
    <message>
        <source>Number of garments in the marker</source>
        <translation>Anzahl der Kleidungsstücke im Schnittbild</translation>
    </message>
    <message>
        <source>Right angle to previous</source>
        <translation>Rechter Winkel zum vorigen</translation>
    </message>
    <message>
        <source>Right angle to this</source>
        <translation>Rechter Winkel zu diesem</translation>
    </message>
    <message>
        <source>Mirrored on previous</source>
        <translation>Gespiegelt am vorigen</translation>
    </message>
    <message>
        <source>Mirrored on this</source>
        <translation>Gespiegelt an diesem</translation>
    </message>
    <message>
        <source>Maximum distance of a line from the exact outline</source>
        <translation>Größter Abstand einer Linie vom genauen Umriss</translation>
    </message>
    <message>
        <source>Maximum distance of this segment&apos;s line from the exact outline; switches on fair lines</source>
        <translation>Größter Abstand der Linie dieses Abschnitts vom genauen Umriss; schaltet ausgeglichene Linien ein</translation>
    </message>
    <message>
        <source>How the allowances meet at the start of the segment, anti-clockwise around the piece</source>
        <translation>Wie die Zugaben am Anfang des Abschnitts zusammentreffen, gegen den Uhrzeigersinn um das Schnittteil</translation>
    </message>
    <message>
        <source>Allowance along sewn edges</source>
        <translation>Zugabe entlang genähter Kanten</translation>
    </message>
    <message>
        <source>Measured inwards from the cutting line; at most half the allowance, if there is one</source>
        <translation>Von der Schnittlinie nach innen gemessen; höchstens die halbe Zugabe, falls es eine gibt</translation>
    </message>
    <message>
        <source>Width between the legs at the edge, in the pattern; the legs keep their length</source>
        <translation>Abstand der Schenkel an der Kante, im Schnittmuster; die Schenkel behalten ihre Länge</translation>
    </message>
    <message>
        <source>Leg over which the closed dart is folded, counted anti-clockwise around the piece. By convention: towards the centre, or downwards</source>
        <translation>Schenkel, über den der geschlossene Abnäher gelegt wird, gezählt gegen den Uhrzeigersinn um das Schnittteil. Üblich: zur Mitte oder nach unten</translation>
    </message>
    <message>
        <source>Size printed on the labels of all pieces</source>
        <translation>Größe auf den Beschriftungen aller Schnittteile</translation>
    </message>
    <message>
        <source>Date printed on the labels of all pieces</source>
        <translation>Datum auf den Beschriftungen aller Schnittteile</translation>
    </message>
    <message>
        <source>Remove kinks of up to this angle where lines meet at the end of a sewn seam</source>
        <translation>Knicke bis zu diesem Winkel entfernen, wo Linien am Ende einer genähten Naht zusammentreffen</translation>
    </message>
    <message>
        <source>Add cloth beyond the seam lines, and a cutting line around it</source>
        <translation>Stoff außerhalb der Nahtlinien zugeben, mit einer Schnittlinie darum</translation>
    </message>
    <message>
        <source>Mark points of seams to align when sewing</source>
        <translation>Stellen der Nähte markieren, die beim Nähen aufeinandertreffen</translation>
    </message>
    <message>
        <source>Leave out fragments too small for a piece; groups of one kind, such as buttons, stay</source>
        <translation>Bruchstücke weglassen, die für ein Schnittteil zu klein sind; mehrere gleiche, etwa Knöpfe, bleiben</translation>
    </message>
    <message>
        <source>Fill holes with cloth; neck, sleeves and hem stay open, however short they are</source>
        <translation>Löcher mit Stoff füllen; Hals, Ärmel und Saum bleiben offen, wie kurz sie auch sind</translation>
    </message>
    <message>
        <source>Largest movement of a point; folds and hems stay</source>
        <translation>Größte Bewegung eines Punktes; Falten und Säume bleiben</translation>
    </message>
    <message>
        <source>Replace the mesh by triangles of about equal size; names and UV map are lost</source>
        <translation>Das Netz durch etwa gleich große Dreiecke ersetzen; Namen und UV-Karte gehen verloren</translation>
    </message>
    <message>
        <source>From fabric</source>
        <translation>Vom Stoff</translation>
    </message>
    <message>
        <source>Force per strain of a strip 1 m wide, stretched along the warp</source>
        <translation>Kraft je Dehnung eines 1 m breiten Streifens bei Zug in Kettrichtung</translation>
    </message>
    <message>
        <source>Force per strain of a strip 1 m wide, stretched along the weft</source>
        <translation>Kraft je Dehnung eines 1 m breiten Streifens bei Zug in Schussrichtung</translation>
    </message>
    <message>
        <source>Only used with gravity</source>
        <translation>Zählt nur mit Schwerkraft</translation>
    </message>
    <message>
        <source>The pattern as written to a file and read back, or another one to compare</source>
        <translation>Der Schnitt, in eine Datei geschrieben und zurückgelesen, oder ein anderer zum Vergleich</translation>
    </message>
    <message>
        <source>Edge length of the sewn triangles; shorter edges are finer and slower. 0: as in the garment</source>
        <translation>Kantenlänge der genähten Dreiecke; kürzere sind feiner und langsamer. 0: wie im Kleidungsstück</translation>
    </message>
    <message>
        <source>Presses the cloth onto the dress form; negative values inflate it. 10 Pa are 1 g on 10 cm²</source>
        <translation>Drückt den Stoff auf den Körper; negative Werte blasen ihn auf. 10 Pa sind 1 g auf 10 cm²</translation>
    </message>
    <message>
        <source>Let the cloth hang under its weight</source>
        <translation>Den Stoff durch sein Gewicht hängen lassen</translation>
    </message>
    <message>
        <source>Keep layers of cloth apart (slower); otherwise cloth passes through cloth</source>
        <translation>Stofflagen auseinanderhalten (langsamer); sonst geht Stoff durch Stoff hindurch</translation>
    </message>
    <message>
        <source>Draw the segment as a straight line; switches on fair lines</source>
        <translation>Den Abschnitt als gerade Linie zeichnen; schaltet ausgeglichene Linien ein</translation>
    </message>
    <message>
        <source>the project needs this file, but it is missing</source>
        <translation>das Projekt braucht diese Datei, sie fehlt</translation>
    </message>
    <message>
        <source>DXF files hold names in plain Latin letters, so these were changed: %1</source>
        <translation>DXF-Dateien enthalten Namen nur in einfachen lateinischen Buchstaben, daher wurden diese geändert: %1</translation>
    </message>
    <message>
        <source>a number has a decimal comma, &quot;%1&quot;; numbers need decimal points</source>
        <translation>eine Zahl hat ein Dezimalkomma, „%1“; Zahlen brauchen Dezimalpunkte</translation>
    </message>
    <message>
        <source>its text says Units: %1, which some programs use for cm; in mm the largest piece would be %2 mm</source>
        <translation>ihr Text sagt Units: %1, was manche Programme für cm verwenden; in mm wäre das größte Teil %2 mm groß</translation>
    </message>
    <message>
        <source>%1 mm, while a file holds at most %2 mm; check the garment&apos;s unit</source>
        <translation>%1 mm, eine Datei fasst aber höchstens %2 mm; prüfen Sie die Einheit des Kleidungsstücks</translation>
    </message>
    <message>
        <source>the grade rules in &quot;%1&quot; are not read, only sizes drawn in the DXF file</source>
        <translation>die Gradierregeln in „%1“ werden nicht gelesen, nur in der DXF-Datei gezeichnete Größen</translation>
    </message>
    <message>
        <source>without texture coordinates: their number does not fit</source>
        <translation>ohne Texturkoordinaten: ihre Anzahl passt nicht</translation>
    </message>
    <message>
        <source>the mesh lies so far from the origin that its coordinates, which are floats, are %1 apart in the file&apos;s unit; move it to the origin and export it again</source>
        <translation>das Netz liegt so weit vom Ursprung, dass seine Koordinaten (einfache Genauigkeit) in der Einheit der Datei %1 auseinanderliegen; verschieben Sie es zum Ursprung und exportieren Sie es erneut</translation>
    </message>
    <message>
        <source>Hem</source>
        <translation>Saum</translation>
    </message>
    <message>
        <source>Cuff</source>
        <translation>Ärmelende</translation>
    </message>
    <message>
        <source>Neckline</source>
        <translation>Halsausschnitt</translation>
    </message>
    <message>
        <source>Armhole</source>
        <translation>Armausschnitt</translation>
    </message>
    <message>
        <source>Waist</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Front edge</source>
        <translation>Vordere Kante</translation>
    </message>
    <message>
        <source>Collar edge</source>
        <translation>Kragenkante</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>&amp;Kind of edge</source>
        <translation>&amp;Art der Kante</translation>
    </message>
    <message>
        <source>Kind of a free edge</source>
        <translation>Art einer freien Kante</translation>
    </message>
    <message>
        <source>What the free edge is on the worn garment; sets the usual width of its allowance</source>
        <translation>Was die freie Kante am getragenen Kleidungsstück ist; bestimmt die übliche Breite ihrer Zugabe</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Wie erkannt</translation>
    </message>
    <message>
        <source>Allowance along hems; other free edges have usual widths of their kinds</source>
        <translation>Zugabe an Säumen; andere freie Kanten haben die üblichen Breiten ihrer Art</translation>
    </message>
    <message>
        <source>Allowance along free edges of this kind</source>
        <translation>Zugabe entlang freier Kanten dieser Art</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>Not settled after %1 steps, so all figures are rough. </source>
        <translation>Nach %1 Schritten nicht zur Ruhe gekommen, daher sind alle Zahlen ungenau. </translation>
    </message>
    <message>
        <source>subdivision is not applied to %1 of its meshes, and the smooth cloth is smaller; apply it in the modelling program</source>
        <translation>auf %1 der Netze ist die Unterteilung nicht angewandt, und der glatte Stoff ist kleiner; wenden Sie sie im Modellierprogramm an</translation>
    </message>
    <message>
        <source>its text says Unit: %1</source>
        <translation>sein Text nennt Unit: %1</translation>
    </message>
</context>
<context>
    <name>toile::app</name>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Read&amp;y to cut?</source>
        <translation>Bereit zu&amp;m Zuschneiden?</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Das Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>Select every piece</source>
        <translation>Alle Schnittteile auswählen</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>&amp;Nichts auswählen</translation>
    </message>
    <message>
        <source>Clear the selection of pieces and seams</source>
        <translation>Die Auswahl von Schnittteilen und Nähten aufheben</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Piece &amp;colours</source>
        <translation>Teile&amp;farben</translation>
    </message>
    <message>
        <source>Check&amp;erboard</source>
        <translation>&amp;Karos</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Karos</translation>
    </message>
    <message>
        <source>&amp;Area change</source>
        <translation>Fl&amp;ächenänderung</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>An&amp;gle change</source>
        <translation>&amp;Winkeländerung</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Edge &amp;strain</source>
        <translation>&amp;Dehnung</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Strain along war&amp;p</source>
        <translation>Dehnung längs der Ke&amp;tte</translation>
    </message>
    <message>
        <source>Warp</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>Strain along we&amp;ft</source>
        <translation>Dehnung längs des Sch&amp;usses</translation>
    </message>
    <message>
        <source>Weft</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>Strain on the &amp;bias</source>
        <translation>Dehnung im Sch&amp;rägen</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>Principal s&amp;train</source>
        <translation>&amp;Hauptdehnung</translation>
    </message>
    <message>
        <source>Principal</source>
        <translation>Hauptdehnung</translation>
    </message>
    <message>
        <source>&amp;Distortion energy</source>
        <translation>&amp;Verzerrungsenergie</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>&amp;Values per triangle</source>
        <translation>Werte &amp;je Dreieck</translation>
    </message>
    <message>
        <source>Per triangle</source>
        <translation>Je Dreieck</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>Schlimmste Stellen</translation>
    </message>
    <message>
        <source>Show &amp;wireframe</source>
        <translation>&amp;Gitternetz zeigen</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Gitternetz</translation>
    </message>
    <message>
        <source>Re&amp;ference panels</source>
        <translation>R&amp;eferenzteile</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>&amp;Röntgenblick</translation>
    </message>
    <message>
        <source>&amp;Draft</source>
        <translation>&amp;Entwurf</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>&amp;Fine</source>
        <translation>&amp;Fein</translation>
    </message>
    <message>
        <source>C&amp;ompare methods…</source>
        <translation>Verfahren &amp;vergleichen…</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Select pieces, seams and vertices; move pieces in the pattern</source>
        <translation>Schnittteile, Nähte und Punkte auswählen; Schnittteile im Schnittmuster verschieben</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Einschneiden</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Einschneiden</translation>
    </message>
    <message>
        <source>Closed &amp;loop</source>
        <translation>&amp;Geschlossener Schnitt</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Rundschnitt</translation>
    </message>
    <message>
        <source>&amp;Dart</source>
        <translation>A&amp;bnäher</translation>
    </message>
    <message>
        <source>Cut from an edge to a tip inside the cloth</source>
        <translation>Von einer Kante bis zu einer Spitze im Stoff einschneiden</translation>
    </message>
    <message>
        <source>Dart</source>
        <translation>Abnäher</translation>
    </message>
    <message>
        <source>&amp;Join</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Flatten &amp;again</source>
        <translation>&amp;Neu abwickeln</translation>
    </message>
    <message>
        <source>Flatten every piece again</source>
        <translation>Alle Schnittteile noch einmal abwickeln</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Abwickeln</translation>
    </message>
    <message>
        <source>Flatten after every ed&amp;it</source>
        <translation>Nach jeder Än&amp;derung abwickeln</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>&amp;Millimetres</source>
        <translation>&amp;Millimeter</translation>
    </message>
    <message>
        <source>Read the file&apos;s numbers as millimetres</source>
        <translation>Die Zahlen der Datei als Millimeter lesen</translation>
    </message>
    <message>
        <source>&amp;Centimetres</source>
        <translation>&amp;Zentimeter</translation>
    </message>
    <message>
        <source>Read the file&apos;s numbers as centimetres</source>
        <translation>Die Zahlen der Datei als Zentimeter lesen</translation>
    </message>
    <message>
        <source>M&amp;etres</source>
        <translation>M&amp;eter</translation>
    </message>
    <message>
        <source>Read the file&apos;s numbers as metres</source>
        <translation>Die Zahlen der Datei als Meter lesen</translation>
    </message>
    <message>
        <source>&amp;Inches</source>
        <translation>Z&amp;oll</translation>
    </message>
    <message>
        <source>Read the file&apos;s numbers as inches</source>
        <translation>Die Zahlen der Datei als Zoll lesen</translation>
    </message>
    <message>
        <source>&amp;Y points up</source>
        <translation>&amp;Y zeigt nach oben</translation>
    </message>
    <message>
        <source>&amp;Z points up</source>
        <translation>&amp;Z zeigt nach oben</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>&amp;Objekten</translation>
    </message>
    <message>
        <source>&amp;Groups</source>
        <translation>&amp;Gruppen</translation>
    </message>
    <message>
        <source>&amp;Materials</source>
        <translation>&amp;Materialien</translation>
    </message>
    <message>
        <source>&amp;UV islands</source>
        <translation>&amp;UV-Inseln</translation>
    </message>
    <message>
        <source>&amp;Cuts only</source>
        <translation>Nur &amp;Einschnitten</translation>
    </message>
    <message>
        <source>&amp;Cut open automatically</source>
        <translation>Von selbst &amp;aufschneiden</translation>
    </message>
    <message>
        <source>&amp;Weld vertices</source>
        <translation>Punkte &amp;verschmelzen</translation>
    </message>
    <message>
        <source>Save sea&amp;ms file…</source>
        <translation>Naht&amp;datei speichern…</translation>
    </message>
    <message>
        <source>&amp;Grain</source>
        <translation>&amp;Fadenlauf</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Fadenlauf</translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>&amp;Mirror left to right</source>
        <translation>&amp;Seitlich spiegeln</translation>
    </message>
    <message>
        <source>Mirror &amp;upside down</source>
        <translation>Nach &amp;oben spiegeln</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>&amp;Linke Kanten</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>&amp;Rechte Kanten</translation>
    </message>
    <message>
        <source>&amp;Upper edges</source>
        <translation>&amp;Obere Kanten</translation>
    </message>
    <message>
        <source>Lo&amp;wer edges</source>
        <translation>&amp;Untere Kanten</translation>
    </message>
    <message>
        <source>Lay &amp;out again</source>
        <translation>Ne&amp;u auslegen</translation>
    </message>
    <message>
        <source>Turn &amp;grain upwards</source>
        <translation>&amp;Fadenlauf nach oben drehen</translation>
    </message>
    <message>
        <source>&amp;Best grain</source>
        <translation>&amp;Bester Fadenlauf</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Bester</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>&amp;Lineale</translation>
    </message>
    <message>
        <source>Show rulers along the edges of the pattern view</source>
        <translation>Lineale an den Rändern der Schnittansicht zeigen</translation>
    </message>
    <message>
        <source>Gri&amp;d</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>&amp;Einrasten</translation>
    </message>
    <message>
        <source>Fa&amp;bric…</source>
        <translation>&amp;Material…</translation>
    </message>
    <message>
        <source>Go to &amp;pieces</source>
        <translation>Zu den &amp;Schnittteilen</translation>
    </message>
    <message>
        <source>Go &amp;to seams</source>
        <translation>Zu den &amp;Nähten</translation>
    </message>
    <message>
        <source>Go to proble&amp;ms</source>
        <translation>Zu den &amp;Problemen</translation>
    </message>
    <message>
        <source>Go to &amp;history</source>
        <translation>Zum &amp;Verlauf</translation>
    </message>
    <message>
        <source>Reset &amp;window layout</source>
        <translation>Fenster&amp;aufteilung zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>E&amp;instellungen…</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Tastatur und Maus</translation>
    </message>
    <message>
        <source>&amp;About Toile</source>
        <translation>&amp;Über Toile</translation>
    </message>
    <message>
        <source>Piece: %1</source>
        <translation>Schnittteil: %1</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>Select the piece and show it in both views</source>
        <translation>Das Schnittteil auswählen und in beiden Ansichten zeigen</translation>
    </message>
    <message>
        <source>Seam %1: %2</source>
        <translation>Naht %1: %2</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Select the seam and show both its edges in both views</source>
        <translation>Die Naht auswählen und ihre beiden Kanten in beiden Ansichten zeigen</translation>
    </message>
    <message>
        <source>In the garment view</source>
        <translation>In der Ansicht des Kleidungsstücks</translation>
    </message>
    <message>
        <source>In the pattern view</source>
        <translation>In der Ansicht des Schnittmusters</translation>
    </message>
    <message>
        <source>In both views</source>
        <translation>In beiden Ansichten</translation>
    </message>
    <message>
        <source>With the Select tool</source>
        <translation>Mit dem Werkzeug Auswählen</translation>
    </message>
    <message>
        <source>With the Cut tool</source>
        <translation>Mit dem Werkzeug Einschneiden</translation>
    </message>
    <message>
        <source>With the Closed loop tool</source>
        <translation>Mit dem Werkzeug Geschlossener Schnitt</translation>
    </message>
    <message>
        <source>With the Dart tool</source>
        <translation>Mit dem Werkzeug Abnäher</translation>
    </message>
    <message>
        <source>With the Join tool</source>
        <translation>Mit dem Werkzeug Verbinden</translation>
    </message>
    <message>
        <source>With the Measure tool</source>
        <translation>Mit dem Werkzeug Messen</translation>
    </message>
    <message>
        <source>With the Grain tool</source>
        <translation>Mit dem Werkzeug Fadenlauf</translation>
    </message>
    <message>
        <source>In the lists</source>
        <translation>In den Listen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>Move the garment</source>
        <translation>Das Kleidungsstück verschieben</translation>
    </message>
    <message>
        <source>Number pad 1, 3, 7</source>
        <translation>Ziffernblock 1, 3, 7</translation>
    </message>
    <message>
        <source>Number pad 9</source>
        <translation>Ziffernblock 9</translation>
    </message>
    <message>
        <source>Show the opposite side</source>
        <translation>Die Seite gegenüber zeigen</translation>
    </message>
    <message>
        <source>Number pad 2, 4, 6, 8</source>
        <translation>Ziffernblock 2, 4, 6, 8</translation>
    </message>
    <message>
        <source>Turn the garment by 15°</source>
        <translation>Das Kleidungsstück um 15° drehen</translation>
    </message>
    <message>
        <source>Number pad 5</source>
        <translation>Ziffernblock 5</translation>
    </message>
    <message>
        <source>Click on the axis cross</source>
        <translation>Klick auf das Achsenkreuz</translation>
    </message>
    <message>
        <source>Show the garment from that side</source>
        <translation>Das Kleidungsstück von dieser Seite zeigen</translation>
    </message>
    <message>
        <source>Toile</source>
        <translation>Toile</translation>
    </message>
    <message>
        <source>Middle or right drag: turn; with Shift: move; with Ctrl: zoom</source>
        <translation>Mit mittlerer oder rechter Taste ziehen: drehen; mit Umschalt: verschieben; mit Strg: vergrößern</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Middle drag or Alt+drag: turn; with Shift: move; with Ctrl: zoom</source>
        <translation>Mit mittlerer Taste oder Alt ziehen: drehen; mit Umschalt: verschieben; mit Strg: vergrößern</translation>
    </message>
    <message>
        <source>CLO</source>
        <translation>CLO</translation>
    </message>
    <message>
        <source>Right drag: turn; middle drag: move</source>
        <translation>Mit rechter Taste ziehen: drehen; mit mittlerer: verschieben</translation>
    </message>
    <message>
        <source>Rhino</source>
        <translation>Rhino</translation>
    </message>
    <message>
        <source>Right drag: turn; with Shift: move; with Ctrl: zoom</source>
        <translation>Mit rechter Taste ziehen: drehen; mit Umschalt: verschieben; mit Strg: vergrößern</translation>
    </message>
    <message>
        <source>Space+drag, middle drag</source>
        <translation>Leertaste+Ziehen, mittlere Taste</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Den Bogen verschieben</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Zoom towards the pointer</source>
        <translation>Auf den Zeiger zu vergrößern</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Ctrl+click, Shift+click</source>
        <translation>Strg+Klick, Umschalt+Klick</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Drag a piece in the pattern view</source>
        <translation>Schnittteil in der Schnittansicht ziehen</translation>
    </message>
    <message>
        <source>Move the selected pieces</source>
        <translation>Die ausgewählten Schnittteile verschieben</translation>
    </message>
    <message>
        <source>Drag the sheet</source>
        <translation>Bogen ziehen</translation>
    </message>
    <message>
        <source>Drag the handle above the selection</source>
        <translation>Am Griff über der Auswahl ziehen</translation>
    </message>
    <message>
        <source>Turn the selected pieces; with Shift: in steps of 15°</source>
        <translation>Die ausgewählten Schnittteile drehen; mit Umschalt: in Schritten von 15°</translation>
    </message>
    <message>
        <source>Alt while dragging</source>
        <translation>Alt beim Ziehen</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Esc while dragging</source>
        <translation>Esc beim Ziehen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Strg+Klick</translation>
    </message>
    <message>
        <source>Double click, Enter</source>
        <translation>Doppelklick, Eingabe</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Click on the first point, double click, Enter</source>
        <translation>Klick auf den ersten Punkt, Doppelklick, Eingabe</translation>
    </message>
    <message>
        <source>Drag from an edge</source>
        <translation>Von einer Kante ziehen</translation>
    </message>
    <message>
        <source>Click an edge, then the tip</source>
        <translation>Kante anklicken, dann die Spitze</translation>
    </message>
    <message>
        <source>Backspace, Esc</source>
        <translation>Rücktaste, Esc</translation>
    </message>
    <message>
        <source>Click a seam</source>
        <translation>Naht anklicken</translation>
    </message>
    <message>
        <source>Ctrl+C</source>
        <translation>Strg+C</translation>
    </message>
    <message>
        <source>Drag on a piece in the pattern view</source>
        <translation>Auf einem Schnittteil in der Schnittansicht ziehen</translation>
    </message>
    <message>
        <source>Turn its grain</source>
        <translation>Seinen Fadenlauf drehen</translation>
    </message>
    <message>
        <source>Select the piece</source>
        <translation>Das Schnittteil auswählen</translation>
    </message>
    <message>
        <source>Select the piece or the seam in both views</source>
        <translation>Das Schnittteil oder die Naht in beiden Ansichten auswählen</translation>
    </message>
    <message>
        <source>Frame the piece or the seam in both views</source>
        <translation>Das Schnittteil oder die Naht in beiden Ansichten einpassen</translation>
    </message>
    <message>
        <source>Right click on the headings</source>
        <translation>Rechtsklick auf die Überschriften</translation>
    </message>
    <message>
        <source>Choose the columns of the list of pieces</source>
        <translation>Die Spalten der Liste der Schnittteile wählen</translation>
    </message>
    <message>
        <source>Click on a heading</source>
        <translation>Klick auf eine Überschrift</translation>
    </message>
    <message>
        <source>Sort by that column</source>
        <translation>Nach dieser Spalte ordnen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>Ü&amp;berlagerung</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>La&amp;yout</source>
        <translation>Aus&amp;legen</translation>
    </message>
    <message>
        <source>&amp;Garment</source>
        <translation>&amp;Kleidungsstück</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Einheit</translation>
    </message>
    <message>
        <source>Up &amp;axis</source>
        <translation>Achse nach &amp;oben</translation>
    </message>
    <message>
        <source>F&amp;latten</source>
        <translation>Abwi&amp;ckeln</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Güte</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n Schnittteil</numerusform>
            <numerusform>%n Schnittteile</numerusform>
        </translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>by objects</source>
        <translation>nach Objekten</translation>
    </message>
    <message>
        <source>by groups</source>
        <translation>nach Gruppen</translation>
    </message>
    <message>
        <source>by materials</source>
        <translation>nach Materialien</translation>
    </message>
    <message>
        <source>by cuts</source>
        <translation>nach Einschnitten</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>y up</source>
        <translation>y oben</translation>
    </message>
    <message>
        <source>z up</source>
        <translation>z oben</translation>
    </message>
    <message>
        <source>%1 (from the file)</source>
        <translation>%1 (aus der Datei)</translation>
    </message>
    <message>
        <source>%1 (guessed)</source>
        <translation>%1 (geschätzt)</translation>
    </message>
    <message>
        <source>height %1 · %2 · %3 %4</source>
        <translation>Höhe %1 · %2 · %3 %4</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 Schnittteil</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 Schnittteile</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>no notes</source>
        <translation>keine Hinweise</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 Hinweis</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 Hinweise</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Not flattened yet</source>
        <translation>Noch nicht abgewickelt</translation>
    </message>
    <message>
        <source>Ready to cut</source>
        <translation>Bereit zum Zuschneiden</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>Least &amp;distortion</source>
        <translation>Kleinste &amp;Verzerrung</translation>
    </message>
    <message>
        <source>1 seam</source>
        <translation>1 Naht</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>%1 Nähte</translation>
    </message>
    <message>
        <source>not measured yet</source>
        <translation>noch nicht gemessen</translation>
    </message>
    <message>
        <source>1 does not match</source>
        <translation>1 passt nicht</translation>
    </message>
    <message>
        <source>%1 do not match</source>
        <translation>%1 passen nicht</translation>
    </message>
    <message>
        <source>1 nearly matches</source>
        <translation>1 passt fast</translation>
    </message>
    <message>
        <source>%1 nearly match</source>
        <translation>%1 passen fast</translation>
    </message>
    <message>
        <source>worst %1 %2</source>
        <translation>schlechteste %1 %2</translation>
    </message>
    <message>
        <source>%1 not measured: a piece is not flat</source>
        <translation>%1 nicht gemessen: ein Schnittteil ist nicht flach</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 · %2 / %3, Δ %4</source>
        <translation>%1 · %2 / %3, Δ %4</translation>
    </message>
    <message>
        <source>%1, from corner to corner · %2 / %3, Δ %4</source>
        <translation>%1, von Ecke zu Ecke · %2 / %3, Δ %4</translation>
    </message>
    <message>
        <source>%1 · %2 not sewn</source>
        <translation>%1 · %2 nicht vernäht</translation>
    </message>
    <message>
        <source>%1 (limit %2)</source>
        <translation>%1 (Grenze %2)</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>%1 · strain %2 %</source>
        <translation>%1 · Dehnung %2 %</translation>
    </message>
    <message>
        <source>Right drag or Space+drag: move the view · Wheel: zoom</source>
        <translation>Rechte Taste oder Leertaste+Ziehen: Ansicht bewegen · Mausrad: vergrößern</translation>
    </message>
    <message>
        <source>Middle drag or Space+drag: move the view · Wheel: zoom</source>
        <translation>Mittlere Taste oder Leertaste+Ziehen: Ansicht bewegen · Mausrad: vergrößern</translation>
    </message>
    <message>
        <source>Drag: turn · Shift+drag: move · Wheel: zoom</source>
        <translation>Ziehen: drehen · Umschalt+Ziehen: verschieben · Mausrad: vergrößern</translation>
    </message>
    <message>
        <source>Middle drag: turn · Shift+middle drag: move · Wheel: zoom</source>
        <translation>Mittlere Taste: drehen · Umschalt+mittlere Taste: verschieben · Mausrad: vergrößern</translation>
    </message>
    <message>
        <source>Right drag: turn · Middle drag: move · Wheel: zoom</source>
        <translation>Rechte Taste: drehen · Mittlere Taste: verschieben · Mausrad: vergrößern</translation>
    </message>
    <message>
        <source>Right drag: turn · Shift+right drag: move · Wheel: zoom</source>
        <translation>Rechte Taste: drehen · Umschalt+rechte Taste: verschieben · Mausrad: vergrößern</translation>
    </message>
    <message>
        <source>Exact o&amp;utline</source>
        <translation>Genauer &amp;Umriss</translation>
    </message>
    <message>
        <source>Go to &amp;lines</source>
        <translation>Zu den &amp;Linien</translation>
    </message>
    <message>
        <source>Mirror &amp;edits</source>
        <translation>Änderungen s&amp;piegeln</translation>
    </message>
    <message>
        <source>Go to s&amp;ymmetry</source>
        <translation>Zur S&amp;ymmetrie</translation>
    </message>
    <message>
        <source>&amp;Cutting line</source>
        <translation>S&amp;chnittlinie</translation>
    </message>
    <message>
        <source>&amp;Notches</source>
        <translation>&amp;Knipse</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Beschriftung</translation>
    </message>
    <message>
        <source>&amp;Notch</source>
        <translation>&amp;Knips</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Knips</translation>
    </message>
    <message>
        <source>With the Notch tool</source>
        <translation>Mit dem Werkzeug Knips</translation>
    </message>
    <message>
        <source>Add a notch there, on both sides of the seam</source>
        <translation>Dort einen Knips setzen, auf beiden Seiten der Naht</translation>
    </message>
    <message>
        <source>Drag a notch</source>
        <translation>Einen Knips ziehen</translation>
    </message>
    <message>
        <source>Click a notch</source>
        <translation>Einen Knips anklicken</translation>
    </message>
    <message>
        <source>Select it</source>
        <translation>Ihn auswählen</translation>
    </message>
    <message>
        <source>Ctrl+click a notch, Del</source>
        <translation>Strg+Klick auf einen Knips, Entf</translation>
    </message>
    <message>
        <source>La&amp;yers</source>
        <translation>&amp;Ebenen</translation>
    </message>
    <message>
        <source>&amp;Seam lines</source>
        <translation>&amp;Nahtlinien</translation>
    </message>
    <message>
        <source>Walk the s&amp;eam</source>
        <translation>Naht ablau&amp;fen</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Oberstoff</translation>
    </message>
    <message>
        <source>Lining</source>
        <translation>Futter</translation>
    </message>
    <message>
        <source>Interfacing</source>
        <translation>Einlage</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>&amp;Innenlinien</translation>
    </message>
    <message>
        <source>&amp;Internal line</source>
        <translation>&amp;Innenlinie</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>Innenlinie</translation>
    </message>
    <message>
        <source>With the Internal line tool</source>
        <translation>Mit dem Werkzeug Innenlinie</translation>
    </message>
    <message>
        <source>Set the next point of the line</source>
        <translation>Den nächsten Punkt der Linie setzen</translation>
    </message>
    <message>
        <source>Click on the first point</source>
        <translation>Klick auf den ersten Punkt</translation>
    </message>
    <message>
        <source>Close the line</source>
        <translation>Die Linie schließen</translation>
    </message>
    <message>
        <source>Click a line</source>
        <translation>Klick auf eine Linie</translation>
    </message>
    <message>
        <source>Drag a point of a line</source>
        <translation>Einen Punkt einer Linie ziehen</translation>
    </message>
    <message>
        <source>Move the point</source>
        <translation>Den Punkt verschieben</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>&amp;Export pattern…</source>
        <translation>Schnitt &amp;exportieren…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>read back: %1, largest difference %2 mm</source>
        <translation>zurückgelesen: %1, größter Unterschied %2 mm</translation>
    </message>
    <message>
        <source>Open reference pa&amp;ttern…</source>
        <translation>&amp;Referenzschnitt öffnen…</translation>
    </message>
    <message>
        <source>&amp;Close reference pattern</source>
        <translation>Referenzs&amp;chnitt schließen</translation>
    </message>
    <message>
        <source>&amp;Print pattern…</source>
        <translation>Schnitt &amp;drucken…</translation>
    </message>
    <message>
        <source>Print the pattern at true scale, on pages to join or on large sheets</source>
        <translation>Den Schnitt maßstabsgetreu drucken, auf Blätter zum Zusammenkleben oder auf große Bögen</translation>
    </message>
    <message>
        <source>read back: %1 x %2 dots</source>
        <translation>zurückgelesen: %1 x %2 Punkte</translation>
    </message>
    <message>
        <source>&amp;Decimetres</source>
        <translation>&amp;Dezimeter</translation>
    </message>
    <message>
        <source>Read the file&apos;s numbers as decimetres, as MakeHuman writes them</source>
        <translation>Die Zahlen der Datei als Dezimeter lesen, wie MakeHuman sie schreibt</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>&amp;Documentation</source>
        <translation>&amp;Dokumentation</translation>
    </message>
    <message>
        <source>&amp;Report a problem…</source>
        <translation>&amp;Problem melden …</translation>
    </message>
    <message>
        <source>1 = %1 mm</source>
        <translation>1 = %1 mm</translation>
    </message>
    <message>
        <source>units of %1 mm</source>
        <translation>Einheiten von %1 mm</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>Dezimeter</translation>
    </message>
    <message>
        <source>by UV islands</source>
        <translation>nach UV-Inseln</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>or the garment is</source>
        <translation>oder das Kleidungsstück ist</translation>
    </message>
    <message>
        <source>tall</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>Which of the file&apos;s axes points up?</source>
        <translation>Welche Achse der Datei zeigt nach oben?</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Quantity…</source>
        <translation>An&amp;zahl…</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Aus&amp;blenden</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Alle zeigen</translation>
    </message>
    <message>
        <source>&amp;Leave out</source>
        <translation>Ausneh&amp;men</translation>
    </message>
    <message>
        <source>Leave out &amp;small pieces…</source>
        <translation>&amp;Kleine Schnittteile ausnehmen…</translation>
    </message>
    <message>
        <source>Right click, menu key, Shift+F10</source>
        <translation>Rechtsklick, Menütaste, Umschalt+F10</translation>
    </message>
    <message>
        <source>Double click on a name, F2</source>
        <translation>Doppelklick auf einen Namen, F2</translation>
    </message>
    <message>
        <source>&amp;Piece</source>
        <translation>&amp;Schnittteil</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>Spie&amp;geln</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Show only %1</source>
        <translation>Nur %1 zeigen</translation>
    </message>
    <message>
        <source>Show all pieces</source>
        <translation>Alle Schnittteile zeigen</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation>%1 ausnehmen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Surface &amp;normals</source>
        <translation>Flächen&amp;normalen</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Align %1</source>
        <translation>%1 ausrichten</translation>
    </message>
    <message>
        <source>Distribute %1</source>
        <translation>%1 verteilen</translation>
    </message>
    <message>
        <source>Lay out %1</source>
        <translation>%1 auslegen</translation>
    </message>
    <message>
        <source>various</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>%1 yd</source>
        <translation>%1 yd</translation>
    </message>
    <message>
        <source>%1 in</source>
        <translation>%1 in</translation>
    </message>
    <message>
        <source>Connected &amp;parts</source>
        <translation>Zusammenhängende &amp;Teile</translation>
    </message>
    <message>
        <source>Cut o&amp;pen</source>
        <translation>Aufs&amp;chneiden</translation>
    </message>
    <message>
        <source>&amp;Dart here…</source>
        <translation>Abnäher &amp;hier…</translation>
    </message>
    <message>
        <source>Move the selected pieces by 1 mm (1/16 in), with Shift by 10 mm (1/2 in)</source>
        <translation>Die ausgewählten Schnittteile um 1 mm (1/16 Zoll) verschieben, mit Umschalt um 10 mm (1/2 Zoll)</translation>
    </message>
    <message>
        <source>Alt+click</source>
        <translation>Alt+Klick</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>by connected parts</source>
        <translation>nach zusammenhängenden Teilen</translation>
    </message>
    <message>
        <source>Least &amp;stretch on a circle</source>
        <translation>Kleinste Dehnung auf dem Krei&amp;s</translation>
    </message>
    <message>
        <source>&amp;Free outline</source>
        <translation>&amp;Freier Umriss</translation>
    </message>
    <message>
        <source>On a ci&amp;rcle</source>
        <translation>Auf dem K&amp;reis</translation>
    </message>
    <message>
        <source>Close s&amp;lits</source>
        <translation>Schlit&amp;ze schließen</translation>
    </message>
    <message>
        <source>a tube with %1 openings</source>
        <translation>ein Schlauch mit %1 Öffnungen</translation>
    </message>
    <message>
        <source>&amp;Plain sheet</source>
        <translation>&amp;Einfache Fläche</translation>
    </message>
    <message>
        <source>Thick shell, &amp;outer surface</source>
        <translation>Dicke Schale, &amp;äußere Fläche</translation>
    </message>
    <message>
        <source>Thick shell, &amp;inner surface</source>
        <translation>Dicke Schale, &amp;innere Fläche</translation>
    </message>
    <message>
        <source>Thick shell, &amp;middle</source>
        <translation>Dicke Schale, &amp;Mitte</translation>
    </message>
    <message>
        <source>a plain sheet</source>
        <translation>eine einfache Fläche</translation>
    </message>
    <message>
        <source>a thick shell</source>
        <translation>eine dicke Schale</translation>
    </message>
    <message>
        <source>a scan</source>
        <translation>ein Scan</translation>
    </message>
    <message>
        <source>layers of cloth</source>
        <translation>Stofflagen</translation>
    </message>
    <message>
        <source>a solid</source>
        <translation>ein Körper</translation>
    </message>
    <message>
        <source>loose triangles, joined</source>
        <translation>lose Dreiecke, verbunden</translation>
    </message>
    <message>
        <source>Outer</source>
        <translation>Äußere</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>Innere</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>&amp;Scan…</source>
        <translation>&amp;Scan…</translation>
    </message>
    <message>
        <source>Complete &amp;half a garment</source>
        <translation>&amp;Halbes Kleidungsstück ergänzen</translation>
    </message>
    <message>
        <source>Turn i&amp;nside out</source>
        <translation>&amp;Wenden</translation>
    </message>
    <message>
        <source>Prepare the scan…</source>
        <translation>Scan aufbereiten…</translation>
    </message>
    <message>
        <source>Select &amp;same material</source>
        <translation>Gleiche S&amp;toffart auswählen</translation>
    </message>
    <message>
        <source>Select same la&amp;yer</source>
        <translation>Gleiche &amp;Lage auswählen</translation>
    </message>
    <message>
        <source>&amp;Layers of cloth, all</source>
        <translation>Stoff&amp;lagen, alle</translation>
    </message>
    <message>
        <source>&amp;New material…</source>
        <translation>&amp;Neue Stoffart …</translation>
    </message>
    <message>
        <source>Mater&amp;ial</source>
        <translation>&amp;Stoffart</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Outer only</source>
        <translation>Nur äußere</translation>
    </message>
    <message>
        <source>Inner only</source>
        <translation>Nur innere</translation>
    </message>
    <message>
        <source>Layer %1 only</source>
        <translation>Nur Lage %1</translation>
    </message>
    <message>
        <source>No layers</source>
        <translation>Keine Lagen</translation>
    </message>
    <message>
        <source>Propose cu&amp;ts…</source>
        <translation>Schnitte vorschla&amp;gen…</translation>
    </message>
    <message>
        <source>Propose cuts…</source>
        <translation>Schnitte vorschlagen …</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>&amp;Worn strain of the sewn cloth</source>
        <translation>Dehnung des &amp;genähten Stoffs</translation>
    </message>
    <message>
        <source>Worn strain</source>
        <translation>Dehnung genäht</translation>
    </message>
    <message>
        <source>Prove by se&amp;wing</source>
        <translation>Durch &amp;Nähen prüfen</translation>
    </message>
    <message>
        <source>Gap of the sewn c&amp;loth</source>
        <translation>A&amp;bstand des genähten Stoffs</translation>
    </message>
    <message>
        <source>&amp;Go to proof</source>
        <translation>Zur &amp;Nähprobe</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>mirroring %1</source>
        <translation>Spiegelung %1</translation>
    </message>
    <message>
        <source>ease %1</source>
        <translation>Mehrweite %1</translation>
    </message>
    <message>
        <source>Sheet &amp;length</source>
        <translation>Bogen&amp;länge</translation>
    </message>
    <message>
        <source>Length of the sheet</source>
        <translation>Länge des Bogens</translation>
    </message>
    <message>
        <source>Along the warp</source>
        <translation>Längs der Kette</translation>
    </message>
    <message>
        <source>Sheet wi&amp;dth</source>
        <translation>Bogen&amp;breite</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Breite des Bogens</translation>
    </message>
    <message>
        <source>Across the warp</source>
        <translation>Quer zur Kette</translation>
    </message>
    <message>
        <source>How far the cloth can be stretched; 0 or more</source>
        <translation>Wie weit sich der Stoff dehnen lässt; 0 oder mehr</translation>
    </message>
    <message>
        <source>Warp, shrinks</source>
        <translation>Kette, schrumpft</translation>
    </message>
    <message>
        <source>Warp, stretches</source>
        <translation>Kette, dehnt sich</translation>
    </message>
    <message>
        <source>Weft, shrinks</source>
        <translation>Schuss, schrumpft</translation>
    </message>
    <message>
        <source>Weft, stretches</source>
        <translation>Schuss, dehnt sich</translation>
    </message>
    <message>
        <source>Bias, shrinks</source>
        <translation>Schräg, schrumpft</translation>
    </message>
    <message>
        <source>Bias, stretches</source>
        <translation>Schräg, dehnt sich</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>Width of the cloth</source>
        <translation>Breite des Stoffs</translation>
    </message>
    <message>
        <source>Fa&amp;cing</source>
        <translation>&amp;Beleg</translation>
    </message>
    <message>
        <source>Facing of an edge</source>
        <translation>Beleg einer Kante</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>&amp;Ease</source>
        <translation>&amp;Einhalteweite</translation>
    </message>
    <message>
        <source>Ease of a seam</source>
        <translation>Einhalteweite einer Naht</translation>
    </message>
    <message>
        <source>How much longer the left side of the seam is than the right side</source>
        <translation>Um wie viel länger die linke Seite der Naht ist als die rechte</translation>
    </message>
    <message>
        <source>3D length</source>
        <translation>3D-Länge</translation>
    </message>
    <message>
        <source>Plus, minus</source>
        <translation>Plus, Minus</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Turn grain of %1 upwards</source>
        <translation>Fadenlauf von %1 nach oben drehen</translation>
    </message>
    <message>
        <source>Set quantity of %1 to %2</source>
        <translation>Anzahl von %1 auf %2 setzen</translation>
    </message>
    <message>
        <source>Set mirrored pair for %1</source>
        <translation>Gespiegeltes Paar für %1 setzen</translation>
    </message>
    <message>
        <source>Clear mirrored pair for %1</source>
        <translation>Gespiegeltes Paar für %1 aufheben</translation>
    </message>
    <message>
        <source>Set material of %1 to garment&apos;s fabric</source>
        <translation>Stoffart von %1 wie Kleidungsstück</translation>
    </message>
    <message>
        <source>Set material of %1 to %2</source>
        <translation>Stoffart von %1 auf %2 setzen</translation>
    </message>
    <message>
        <source>Draw %1 as half</source>
        <translation>%1 halb zeichnen</translation>
    </message>
    <message>
        <source>Draw %1 as whole</source>
        <translation>%1 ganz zeichnen</translation>
    </message>
    <message>
        <source>Include %1</source>
        <translation>%1 wieder aufnehmen</translation>
    </message>
    <message>
        <source>a closed surface</source>
        <translation>eine geschlossene Fläche</translation>
    </message>
    <message>
        <source>set length %1</source>
        <translation>gesetzte Länge %1</translation>
    </message>
    <message>
        <source>improvement %1</source>
        <translation>Verbesserung %1</translation>
    </message>
    <message>
        <source>Angles from c&amp;urvature</source>
        <translation>Winkel aus der &amp;Krümmung</translation>
    </message>
    <message>
        <source>&amp;Even angles (Wang 2005)</source>
        <translation>Gleich&amp;mäßige Winkel (Wang 2005)</translation>
    </message>
    <message>
        <source>LSCM (&amp;texture style)</source>
        <translation>LSCM (Te&amp;xturart)</translation>
    </message>
    <message>
        <source>A&amp;BF (texture style)</source>
        <translation>A&amp;BF (Texturart)</translation>
    </message>
    <message>
        <source>%1 · %2 / %3 in 3D</source>
        <translation>%1 · %2 / %3 in 3D</translation>
    </message>
    <message>
        <source>%1 · %2 of free edge</source>
        <translation>%1 · %2 freie Kante</translation>
    </message>
    <message>
        <source>%1, from corner to corner · %2 / %3 in 3D</source>
        <translation>%1, von Ecke zu Ecke · %2 / %3 in 3D</translation>
    </message>
    <message>
        <source>Save all your work on this garment in its project file</source>
        <translation>Alle Arbeit an diesem Kleidungsstück in seiner Projektdatei speichern</translation>
    </message>
    <message>
        <source>Save all your work on this garment in another project file</source>
        <translation>Alle Arbeit an diesem Kleidungsstück in einer anderen Projektdatei speichern</translation>
    </message>
    <message>
        <source>Write the pattern to a file for printers, cutters, pattern programs or 3D programs</source>
        <translation>Den Schnitt in eine Datei schreiben: für Drucker, Cutter, Schnitt- oder 3D-Programme</translation>
    </message>
    <message>
        <source>Show a DXF, SVG or GarmentCode pattern over the flat pieces to compare them</source>
        <translation>Zum Vergleich einen Schnitt über den flachen Schnittteilen zeigen: DXF, SVG oder GarmentCode</translation>
    </message>
    <message>
        <source>Stop comparing with the reference pattern</source>
        <translation>Den Vergleich mit dem Referenzschnitt beenden</translation>
    </message>
    <message>
        <source>Check whether the pattern can be cut, and list every problem with its place</source>
        <translation>Prüfen, ob der Schnitt zugeschnitten werden kann, und jedes Problem mit seiner Stelle auflisten</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Den letzten Schritt rückgängig machen</translation>
    </message>
    <message>
        <source>Redo the step that you undid last</source>
        <translation>Den zuletzt rückgängig gemachten Schritt wiederholen</translation>
    </message>
    <message>
        <source>Select every piece with the material of the selected pieces</source>
        <translation>Alle Schnittteile mit der Stoffart der ausgewählten auswählen</translation>
    </message>
    <message>
        <source>Select every piece in the layers of the selected pieces</source>
        <translation>Alle Schnittteile in den Lagen der ausgewählten auswählen</translation>
    </message>
    <message>
        <source>Fit the selected pieces or seam in the view, or everything without a selection</source>
        <translation>Die ausgewählten Schnittteile oder die ausgewählte Naht in die Ansicht einpassen, ohne Auswahl alles</translation>
    </message>
    <message>
        <source>Show every piece in its own colour</source>
        <translation>Jedes Schnittteil in seiner eigenen Farbe zeigen</translation>
    </message>
    <message>
        <source>Show true-scale squares on the cloth</source>
        <translation>Maßstäbliche Karos auf dem Stoff zeigen</translation>
    </message>
    <message>
        <source>Show how much area the cloth must gain or lose to take its shape</source>
        <translation>Zeigen, wie viel Fläche der Stoff für seine Form gewinnen oder verlieren muss</translation>
    </message>
    <message>
        <source>Show how much the angles of the cloth change</source>
        <translation>Zeigen, wie stark sich die Winkel im Stoff ändern</translation>
    </message>
    <message>
        <source>Show how far the cloth must stretch or shrink to take its shape</source>
        <translation>Zeigen, wie weit sich der Stoff für seine Form dehnen oder stauchen muss</translation>
    </message>
    <message>
        <source>Show how far the cloth must stretch or shrink along the grain</source>
        <translation>Zeigen, wie weit sich der Stoff im Fadenlauf dehnen oder stauchen muss</translation>
    </message>
    <message>
        <source>Show how far the cloth must stretch or shrink across the grain</source>
        <translation>Zeigen, wie weit sich der Stoff quer zum Fadenlauf dehnen oder stauchen muss</translation>
    </message>
    <message>
        <source>Show the larger of the strains along the two diagonals, at 45° to the grain</source>
        <translation>Die größere der Dehnungen in den beiden Diagonalen zeigen, unter 45° zum Fadenlauf</translation>
    </message>
    <message>
        <source>Draw crosses along the directions of largest and least strain</source>
        <translation>Kreuze in den Richtungen der größten und der kleinsten Dehnung zeichnen</translation>
    </message>
    <message>
        <source>Show the symmetric Dirichlet energy: one number for strain in all directions</source>
        <translation>Die symmetrische Dirichlet-Energie zeigen: eine Zahl für die Dehnung in allen Richtungen</translation>
    </message>
    <message>
        <source>Show which way the garment&apos;s surface faces, one colour per direction</source>
        <translation>Zeigen, wohin die Fläche des Kleidungsstücks weist, eine Farbe je Richtung</translation>
    </message>
    <message>
        <source>Show how far the sewn pattern lies outside or inside the design</source>
        <translation>Zeigen, wie weit der genähte Schnitt außerhalb oder innerhalb des Entwurfs liegt</translation>
    </message>
    <message>
        <source>Show the strain of the cloth in the sewn pattern</source>
        <translation>Die Dehnung des Stoffs im genähten Schnitt zeigen</translation>
    </message>
    <message>
        <source>Colour every triangle by its own value, without smoothing</source>
        <translation>Jedes Dreieck nach seinem eigenen Wert färben, ohne zu glätten</translation>
    </message>
    <message>
        <source>Mark w&amp;orst spots</source>
        <translation>&amp;Schlimmste Stellen markieren</translation>
    </message>
    <message>
        <source>Number the places with the worst values</source>
        <translation>Die Stellen mit den schlimmsten Werten nummerieren</translation>
    </message>
    <message>
        <source>Show the triangles of the mesh</source>
        <translation>Die Dreiecke des Netzes zeigen</translation>
    </message>
    <message>
        <source>Show the file&apos;s reference panels or the open reference pattern over the flat pieces</source>
        <translation>Die Referenzteile der Datei oder den geöffneten Referenzschnitt über den flachen Schnittteilen zeigen</translation>
    </message>
    <message>
        <source>Show the outline as solved, dashed, if the pattern draws a fair line instead</source>
        <translation>Den berechneten Umriss gestrichelt zeigen, wenn der Schnitt eine ausgeglichene Linie zeichnet</translation>
    </message>
    <message>
        <source>Show the seam lines, with both sides of a seam in one colour</source>
        <translation>Die Nahtlinien zeigen, beide Seiten einer Naht in einer Farbe</translation>
    </message>
    <message>
        <source>Show the cutting line of pieces with a seam allowance</source>
        <translation>Die Schnittlinie der Schnittteile mit Nahtzugabe zeigen</translation>
    </message>
    <message>
        <source>Show the notches of the pattern</source>
        <translation>Die Knipse des Schnittmusters zeigen</translation>
    </message>
    <message>
        <source>Show internal lines, drill points and, in the pattern, dart marks</source>
        <translation>Innenlinien, Bohrpunkte und im Schnittmuster die Zeichen der Abnäher zeigen</translation>
    </message>
    <message>
        <source>Show the grain line of each piece in the pattern view</source>
        <translation>Den Fadenlauf jedes Schnittteils in der Schnittansicht zeigen</translation>
    </message>
    <message>
        <source>Show the names of the pieces in the pattern view</source>
        <translation>Die Namen der Schnittteile in der Schnittansicht zeigen</translation>
    </message>
    <message>
        <source>See through the cloth of the garment</source>
        <translation>Durch den Stoff des Kleidungsstücks sehen</translation>
    </message>
    <message>
        <source>S&amp;hading</source>
        <translation>&amp;Licht und Schatten</translation>
    </message>
    <message>
        <source>Light the garment; without shading it has flat colours like the pattern</source>
        <translation>Das Kleidungsstück beleuchten; sonst hat es gleichmäßige Farben wie das Schnittmuster</translation>
    </message>
    <message>
        <source>Colour p&amp;ieces</source>
        <translation>Schnittteile &amp;färben</translation>
    </message>
    <message>
        <source>Give every piece its own colour; otherwise all pieces are plain cotton</source>
        <translation>Jedem Schnittteil eine eigene Farbe geben; sonst sind alle schlichte Baumwolle</translation>
    </message>
    <message>
        <source>&amp;Front view</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>Look at the garment&apos;s front (number pad 1)</source>
        <translation>Das Kleidungsstück von vorn ansehen (Ziffernblock 1)</translation>
    </message>
    <message>
        <source>&amp;Back view</source>
        <translation>Von &amp;hinten</translation>
    </message>
    <message>
        <source>Look at the garment&apos;s back (Ctrl+number pad 1)</source>
        <translation>Das Kleidungsstück von hinten ansehen (Strg+Ziffernblock 1)</translation>
    </message>
    <message>
        <source>&amp;Right view</source>
        <translation>Von &amp;rechts</translation>
    </message>
    <message>
        <source>Look at the garment from the right of the view (number pad 3)</source>
        <translation>Das Kleidungsstück von der rechten Seite der Ansicht ansehen (Ziffernblock 3)</translation>
    </message>
    <message>
        <source>&amp;Left view</source>
        <translation>Von &amp;links</translation>
    </message>
    <message>
        <source>Look at the garment from the left of the view (Ctrl+number pad 3)</source>
        <translation>Das Kleidungsstück von der linken Seite der Ansicht ansehen (Strg+Ziffernblock 3)</translation>
    </message>
    <message>
        <source>&amp;Top view</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>Look down at the garment (number pad 7)</source>
        <translation>Von oben auf das Kleidungsstück sehen (Ziffernblock 7)</translation>
    </message>
    <message>
        <source>B&amp;ottom view</source>
        <translation>Von &amp;unten</translation>
    </message>
    <message>
        <source>Look up at the garment (Ctrl+number pad 7)</source>
        <translation>Von unten auf das Kleidungsstück sehen (Strg+Ziffernblock 7)</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>Draw the garment without perspective (number pad 5)</source>
        <translation>Das Kleidungsstück ohne Perspektive zeichnen (Ziffernblock 5)</translation>
    </message>
    <message>
        <source>Play fla&amp;ttening</source>
        <translation>&amp;Abwickeln abspielen</translation>
    </message>
    <message>
        <source>Watch the garment turn into the pattern, or the pattern into the garment</source>
        <translation>Zusehen, wie das Kleidungsstück zum Schnitt wird oder der Schnitt zum Kleidungsstück</translation>
    </message>
    <message>
        <source>Play sewi&amp;ng</source>
        <translation>Nä&amp;hen abspielen</translation>
    </message>
    <message>
        <source>Watch the cloth move from the design to the sewn pattern&apos;s resting shape</source>
        <translation>Zusehen, wie sich der Stoff vom Entwurf zur Ruhelage des genähten Schnitts bewegt</translation>
    </message>
    <message>
        <source>Roll one piece along the selected seam to see whether lengths and notches match</source>
        <translation>Ein Schnittteil an der ausgewählten Naht abrollen und sehen, ob Längen und Knipse passen</translation>
    </message>
    <message>
        <source>Keep exact seam lengths; the cloth between stretches as little as possible, without flipped triangles</source>
        <translation>Nahtlängen genau halten; der Stoff dazwischen dehnt sich so wenig wie möglich, ohne umgeklappte Dreiecke</translation>
    </message>
    <message>
        <source>Keep exact seam lengths; the outline turns where the garment is curved</source>
        <translation>Nahtlängen genau halten; der Umriss dreht sich dort, wo das Kleidungsstück gekrümmt ist</translation>
    </message>
    <message>
        <source>Keep exact seam lengths; angle changes spread evenly along the outline (Wang 2005)</source>
        <translation>Nahtlängen genau halten; Winkeländerungen verteilen sich gleichmäßig am Umriss (Wang 2005)</translation>
    </message>
    <message>
        <source>Keep exact seam lengths on a round outline; the inside stretches least (Yoshizawa 2004)</source>
        <translation>Nahtlängen auf rundem Umriss genau halten; das Innere dehnt sich am wenigsten (Yoshizawa 2004)</translation>
    </message>
    <message>
        <source>Keep exact seam lengths on a round outline; not usable as a pattern (Floater 2003)</source>
        <translation>Nahtlängen auf rundem Umriss genau halten; als Schnitt nicht verwendbar (Floater 2003)</translation>
    </message>
    <message>
        <source>Keep angles as far as possible; seam lines change length (Desbrun 2002)</source>
        <translation>Winkel möglichst halten; Nahtlinien ändern ihre Länge (Desbrun 2002)</translation>
    </message>
    <message>
        <source>Keep angles by least squares; seam lines change length (Lévy 2002)</source>
        <translation>Winkel nach kleinsten Quadraten halten; Nahtlinien ändern ihre Länge (Lévy 2002)</translation>
    </message>
    <message>
        <source>Keep the angles of every triangle; seam lines change length (Sheffer 2005)</source>
        <translation>Die Winkel jedes Dreiecks möglichst halten; Nahtlinien ändern ihre Länge (Sheffer 2005)</translation>
    </message>
    <message>
        <source>Fast: within a few per cent of the least distortion</source>
        <translation>Schnell: auf wenige Prozent an der kleinsten Verzerrung</translation>
    </message>
    <message>
        <source>Within about 0.1 % of the least distortion</source>
        <translation>Auf etwa 0,1 % an der kleinsten Verzerrung</translation>
    </message>
    <message>
        <source>Slow: as close to the least distortion as possible</source>
        <translation>Langsam: so nah wie möglich an der kleinsten Verzerrung</translation>
    </message>
    <message>
        <source>&amp;Newton solver</source>
        <translation>New&amp;ton-Verfahren</translation>
    </message>
    <message>
        <source>Solve the outline by Newton steps, the fast way</source>
        <translation>Den Umriss in schnellen Newton-Schritten berechnen</translation>
    </message>
    <message>
        <source>Wang 2005 so&amp;lver</source>
        <translation>Verfahren von &amp;Wang 2005</translation>
    </message>
    <message>
        <source>Solve the same outline by linearly constrained steps, as in the paper</source>
        <translation>Denselben Umriss in linear beschränkten Schritten berechnen, wie im Aufsatz</translation>
    </message>
    <message>
        <source>Compare one piece flattened by up to four methods, side by side</source>
        <translation>Ein Schnittteil nach bis zu vier Verfahren nebeneinander vergleichen</translation>
    </message>
    <message>
        <source>Mar&amp;ker (lay on fabric)…</source>
        <translation>Schnit&amp;tbild (auf Stoff legen)…</translation>
    </message>
    <message>
        <source>Place the pieces on fabric with little waste, and see the length needed</source>
        <translation>Die Schnittteile mit wenig Verschnitt auf den Stoff legen und die nötige Länge sehen</translation>
    </message>
    <message>
        <source>Sew the exported pattern together over the design and measure the difference</source>
        <translation>Den exportierten Schnitt über dem Entwurf zusammennähen und die Abweichung messen</translation>
    </message>
    <message>
        <source>Save proo&amp;f report…</source>
        <translation>Näh&amp;probenbericht speichern…</translation>
    </message>
    <message>
        <source>Write the results of the proof to a JSON file</source>
        <translation>Die Ergebnisse der Nähprobe in eine JSON-Datei schreiben</translation>
    </message>
    <message>
        <source>Cut a piece along the shortest path through the points you click</source>
        <translation>Ein Schnittteil auf dem kürzesten Weg durch die angeklickten Punkte einschneiden</translation>
    </message>
    <message>
        <source>Cut out a part along a closed line through the points you click</source>
        <translation>Einen Teil entlang einer geschlossenen Linie durch die angeklickten Punkte ausschneiden</translation>
    </message>
    <message>
        <source>Join the cloth on both sides of a seam</source>
        <translation>Den Stoff auf beiden Seiten einer Naht verbinden</translation>
    </message>
    <message>
        <source>Measure straight or along edges, on the garment and in the pattern</source>
        <translation>Gerade oder entlang von Kanten messen, am Kleidungsstück und im Schnittmuster</translation>
    </message>
    <message>
        <source>Flatten changed pieces after every edit; turn it off for large meshes</source>
        <translation>Geänderte Schnittteile nach jeder Änderung abwickeln; bei großen Netzen ausschalten</translation>
    </message>
    <message>
        <source>Stop the running task</source>
        <translation>Den laufenden Vorgang anhalten</translation>
    </message>
    <message>
        <source>Read the garment&apos;s files again</source>
        <translation>Die Dateien des Kleidungsstücks noch einmal lesen</translation>
    </message>
    <message>
        <source>Choose the unit that makes the garment human-sized</source>
        <translation>Die Einheit wählen, die ein Kleidungsstück in Menschengröße ergibt</translation>
    </message>
    <message>
        <source>Detect the axis along which the garment stands upright</source>
        <translation>Die Achse erkennen, an der das Kleidungsstück aufrecht steht</translation>
    </message>
    <message>
        <source>Stand the garment along the file&apos;s y axis</source>
        <translation>Das Kleidungsstück an der y-Achse der Datei aufstellen</translation>
    </message>
    <message>
        <source>Stand the garment along the file&apos;s z axis</source>
        <translation>Das Kleidungsstück an der z-Achse der Datei aufstellen</translation>
    </message>
    <message>
        <source>Detect the kind of file: sheet, thick shell, layers or scan</source>
        <translation>Die Art der Datei erkennen: Fläche, dicke Schale, Lagen oder Scan</translation>
    </message>
    <message>
        <source>Use every face of the file unchanged</source>
        <translation>Jede Fläche der Datei unverändert verwenden</translation>
    </message>
    <message>
        <source>Use the outer surface of thick cloth, without its rims</source>
        <translation>Von dickem Stoff die äußere Fläche verwenden, ohne die Ränder</translation>
    </message>
    <message>
        <source>Use the inner surface of thick cloth, without its rims</source>
        <translation>Von dickem Stoff die innere Fläche verwenden, ohne die Ränder</translation>
    </message>
    <message>
        <source>Use the middle between the surfaces of thick cloth</source>
        <translation>Von dickem Stoff die Mitte zwischen den Flächen verwenden</translation>
    </message>
    <message>
        <source>Use every nested sheet, such as a lining; each layer becomes a material</source>
        <translation>Alle ineinander liegenden Flächen verwenden, etwa ein Futter; jede Lage wird eine Stoffart</translation>
    </message>
    <message>
        <source>Layers of cloth, ou&amp;termost only</source>
        <translation>Stofflagen, nur die ä&amp;ußerste</translation>
    </message>
    <message>
        <source>Use only the outermost of nested sheets</source>
        <translation>Von ineinander liegenden Flächen nur die äußerste verwenden</translation>
    </message>
    <message>
        <source>Layers of cloth, secon&amp;d only</source>
        <translation>Stofflagen, nur die &amp;zweite</translation>
    </message>
    <message>
        <source>Use only the second nested sheet from outside, usually the lining</source>
        <translation>Von ineinander liegenden Flächen nur die zweite von außen verwenden, meist das Futter</translation>
    </message>
    <message>
        <source>Turn a scan into a sheet: remove debris, close small holes, smooth noise</source>
        <translation>Einen Scan zur Fläche machen: Bruchstücke entfernen, kleine Löcher schließen, Rauschen glätten</translation>
    </message>
    <message>
        <source>Choose how to split the garment from the contents of the file</source>
        <translation>Die Aufteilung des Kleidungsstücks nach dem Inhalt der Datei wählen</translation>
    </message>
    <message>
        <source>Make each connected part one piece</source>
        <translation>Jeden zusammenhängenden Teil zu einem Schnittteil machen</translation>
    </message>
    <message>
        <source>Make each object of the file one piece</source>
        <translation>Jedes Objekt der Datei zu einem Schnittteil machen</translation>
    </message>
    <message>
        <source>Make each group of the file one piece</source>
        <translation>Jede Gruppe der Datei zu einem Schnittteil machen</translation>
    </message>
    <message>
        <source>Make each material of the file one piece</source>
        <translation>Jedes Material der Datei zu einem Schnittteil machen</translation>
    </message>
    <message>
        <source>Make each UV island of the file one piece</source>
        <translation>Jede UV-Insel der Datei zu einem Schnittteil machen</translation>
    </message>
    <message>
        <source>Split the garment only along the cuts of the seams file</source>
        <translation>Das Kleidungsstück nur entlang der Einschnitte der Nahtdatei teilen</translation>
    </message>
    <message>
        <source>Cut open every piece that cannot lie flat</source>
        <translation>Jedes Schnittteil aufschneiden, das nicht flach liegen kann</translation>
    </message>
    <message>
        <source>Add the mirror image if the file has only half the garment</source>
        <translation>Das Spiegelbild ergänzen, wenn die Datei nur das halbe Kleidungsstück enthält</translation>
    </message>
    <message>
        <source>Flip all faces so that the other side of the cloth is the right side</source>
        <translation>Alle Flächen wenden, sodass die andere Stoffseite die rechte ist</translation>
    </message>
    <message>
        <source>Cut li&amp;ke a tailor</source>
        <translation>Wie S&amp;chneider aufschneiden</translation>
    </message>
    <message>
        <source>Cut one-piece garments at armholes, sides and shoulders if Toile detects them</source>
        <translation>Einteilige Kleidungsstücke an Armlöchern, Seiten und Schultern aufschneiden, wenn Toile sie erkennt</translation>
    </message>
    <message>
        <source>Propose a tailor&apos;s cuts for the selected piece, with their length and effect on strain</source>
        <translation>Schneiderschnitte für das ausgewählte Schnittteil vorschlagen, mit Länge und Wirkung auf die Dehnung</translation>
    </message>
    <message>
        <source>Merge vertices of an object that lie at the same point</source>
        <translation>Punkte eines Objekts verschmelzen, die an derselben Stelle liegen</translation>
    </message>
    <message>
        <source>Close slits inside pieces, common in texture maps</source>
        <translation>Schlitze innerhalb von Schnittteilen schließen, wie sie in Texturkarten vorkommen</translation>
    </message>
    <message>
        <source>Load &amp;seams file…</source>
        <translation>&amp;Nahtdatei laden…</translation>
    </message>
    <message>
        <source>Load cuts and ease from a seams file (JSON)</source>
        <translation>Einschnitte und Einhalteweiten aus einer Nahtdatei (JSON) laden</translation>
    </message>
    <message>
        <source>Write your cuts and ease values to a seams file (JSON)</source>
        <translation>Ihre Einschnitte und Einhalteweiten in eine Nahtdatei (JSON) schreiben</translation>
    </message>
    <message>
        <source>Change the name of the selected piece, on screen and in files</source>
        <translation>Den Namen des ausgewählten Schnittteils ändern, am Bildschirm und in Dateien</translation>
    </message>
    <message>
        <source>Set how many of each selected piece to cut</source>
        <translation>Festlegen, wie oft jedes ausgewählte Schnittteil zugeschnitten wird</translation>
    </message>
    <message>
        <source>Cut the selected pieces from a new material, such as lining or interfacing</source>
        <translation>Die ausgewählten Schnittteile aus einer neuen Stoffart zuschneiden, etwa Futter oder Einlage</translation>
    </message>
    <message>
        <source>Hide the selected pieces in both views; files and checks still include them</source>
        <translation>Die ausgewählten Schnittteile in beiden Ansichten ausblenden; Dateien und Prüfungen enthalten sie weiter</translation>
    </message>
    <message>
        <source>Sho&amp;w only selected</source>
        <translation>Nur ausge&amp;wählte zeigen</translation>
    </message>
    <message>
        <source>Hide all other pieces; files and checks still include them</source>
        <translation>Alle anderen Schnittteile ausblenden; Dateien und Prüfungen enthalten sie weiter</translation>
    </message>
    <message>
        <source>Show the hidden pieces again</source>
        <translation>Die ausgeblendeten Schnittteile wieder zeigen</translation>
    </message>
    <message>
        <source>&amp;Export selected…</source>
        <translation>Ausgewählte &amp;exportieren…</translation>
    </message>
    <message>
        <source>Write only the selected pieces to a file</source>
        <translation>Nur die ausgewählten Schnittteile in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Remove the selected pieces from pattern, files and checks, such as buttons and zips</source>
        <translation>Die ausgewählten Schnittteile aus Schnitt, Dateien und Prüfungen ausnehmen, etwa Knöpfe und Reißverschlüsse</translation>
    </message>
    <message>
        <source>I&amp;nclude again</source>
        <translation>Wie&amp;der aufnehmen</translation>
    </message>
    <message>
        <source>Return the selected left-out pieces to the pattern</source>
        <translation>Die ausgewählten ausgenommenen Schnittteile wieder in den Schnitt aufnehmen</translation>
    </message>
    <message>
        <source>Leave out all pieces smaller than an area that you set</source>
        <translation>Alle Schnittteile ausnehmen, die kleiner als eine gewählte Fläche sind</translation>
    </message>
    <message>
        <source>Cut open those selected pieces that cannot lie flat</source>
        <translation>Die ausgewählten Schnittteile aufschneiden, die nicht flach liegen können</translation>
    </message>
    <message>
        <source>Propose a dart to the pointer or ring: Enter cuts it, Esc discards it</source>
        <translation>Einen Abnäher zum Zeiger oder Ring vorschlagen: Eingabe schneidet ihn, Esc verwirft ihn</translation>
    </message>
    <message>
        <source>Set &amp;ease…</source>
        <translation>&amp;Einhalteweite setzen…</translation>
    </message>
    <message>
        <source>Set how much longer the left edge of the selected seam is</source>
        <translation>Festlegen, wie viel länger die linke Kante der ausgewählten Naht ist</translation>
    </message>
    <message>
        <source>&amp;Join at seam</source>
        <translation>An Naht &amp;verbinden</translation>
    </message>
    <message>
        <source>Join the cloth at the selected seam; removes your own cut there</source>
        <translation>Den Stoff an der ausgewählten Naht verbinden; entfernt dort Ihren Einschnitt</translation>
    </message>
    <message>
        <source>Rese&amp;t ease</source>
        <translation>Einhalteweite &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Use the ease that follows from the 3D lengths of the selected seam</source>
        <translation>Die Einhalteweite verwenden, die sich aus den 3D-Längen der ausgewählten Naht ergibt</translation>
    </message>
    <message>
        <source>Turn the grain of a piece in the pattern view</source>
        <translation>Den Fadenlauf eines Schnittteils in der Schnittansicht drehen</translation>
    </message>
    <message>
        <source>Add, move and delete notches on both sides of a seam at once</source>
        <translation>Knipse auf beiden Seiten einer Naht zugleich setzen, verschieben und löschen</translation>
    </message>
    <message>
        <source>Draw and edit internal lines and drill points</source>
        <translation>Innenlinien und Bohrpunkte zeichnen und ändern</translation>
    </message>
    <message>
        <source>Turn the selected pieces 90° anti-clockwise</source>
        <translation>Die ausgewählten Schnittteile um 90° gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the selected pieces 90° clockwise</source>
        <translation>Die ausgewählten Schnittteile um 90° im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Flip the selected pieces left to right, so that the wrong side faces you</source>
        <translation>Die ausgewählten Schnittteile seitlich wenden, sodass die linke Stoffseite oben liegt</translation>
    </message>
    <message>
        <source>Flip the selected pieces top to bottom, so that the wrong side faces you</source>
        <translation>Die ausgewählten Schnittteile von oben nach unten wenden, sodass die linke Stoffseite oben liegt</translation>
    </message>
    <message>
        <source>Align the left edges of the selected pieces</source>
        <translation>Die ausgewählten Schnittteile an ihren linken Kanten ausrichten</translation>
    </message>
    <message>
        <source>Align the right edges of the selected pieces</source>
        <translation>Die ausgewählten Schnittteile an ihren rechten Kanten ausrichten</translation>
    </message>
    <message>
        <source>Align the upper edges of the selected pieces</source>
        <translation>Die ausgewählten Schnittteile an ihren oberen Kanten ausrichten</translation>
    </message>
    <message>
        <source>Align the lower edges of the selected pieces</source>
        <translation>Die ausgewählten Schnittteile an ihren unteren Kanten ausrichten</translation>
    </message>
    <message>
        <source>Centre on &amp;vertical line</source>
        <translation>Auf &amp;senkrechter Linie mitteln</translation>
    </message>
    <message>
        <source>Centre the selected pieces on one vertical line</source>
        <translation>Die ausgewählten Schnittteile auf einer senkrechten Linie mitteln</translation>
    </message>
    <message>
        <source>Centre on &amp;horizontal line</source>
        <translation>Auf &amp;waagerechter Linie mitteln</translation>
    </message>
    <message>
        <source>Centre the selected pieces on one horizontal line</source>
        <translation>Die ausgewählten Schnittteile auf einer waagerechten Linie mitteln</translation>
    </message>
    <message>
        <source>&amp;Distribute horizontally</source>
        <translation>Waa&amp;gerecht verteilen</translation>
    </message>
    <message>
        <source>Make the horizontal gaps between the selected pieces equal</source>
        <translation>Die waagerechten Abstände der ausgewählten Schnittteile gleich machen</translation>
    </message>
    <message>
        <source>Distribute verticall&amp;y</source>
        <translation>Senkre&amp;cht verteilen</translation>
    </message>
    <message>
        <source>Make the vertical gaps between the selected pieces equal</source>
        <translation>Die senkrechten Abstände der ausgewählten Schnittteile gleich machen</translation>
    </message>
    <message>
        <source>Arrange the selected pieces in rows; without a selection, all pieces</source>
        <translation>Die ausgewählten Schnittteile in Reihen anordnen, ohne Auswahl alle</translation>
    </message>
    <message>
        <source>Turn the selected pieces so that their grain runs upwards; without a selection, all</source>
        <translation>Die ausgewählten Schnittteile mit dem Fadenlauf nach oben drehen, ohne Auswahl alle</translation>
    </message>
    <message>
        <source>Ver&amp;tical grain</source>
        <translation>Fadenlauf senkrec&amp;ht</translation>
    </message>
    <message>
        <source>Run the grain of the selected pieces, or of all, up the garment</source>
        <translation>Den Fadenlauf der ausgewählten Schnittteile, sonst aller, am Kleidungsstück nach oben legen</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Grain &amp;from reference panels</source>
        <translation>Fadenlauf &amp;der Referenzteile</translation>
    </message>
    <message>
        <source>Run the grain up the reference panels; pieces without a panel get vertical grain</source>
        <translation>Den Fadenlauf in den Referenzteilen nach oben legen; Schnittteile ohne Referenzteil: senkrecht</translation>
    </message>
    <message>
        <source>Run the grain upwards, or turn it 45° or 90° if that strains much less</source>
        <translation>Den Fadenlauf nach oben legen, oder um 45° oder 90° gedreht, wenn das viel weniger dehnt</translation>
    </message>
    <message>
        <source>R&amp;eset grain</source>
        <translation>Fadenlauf &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Clear the grain of the selected pieces, or of all</source>
        <translation>Den Fadenlauf der ausgewählten Schnittteile, sonst aller, löschen</translation>
    </message>
    <message>
        <source>Show a grid in the pattern view</source>
        <translation>Ein Raster in der Schnittansicht zeigen</translation>
    </message>
    <message>
        <source>Snap moving pieces to the grid and to each other; Alt toggles this</source>
        <translation>Bewegte Schnittteile am Raster und aneinander einrasten lassen; Alt kehrt es um</translation>
    </message>
    <message>
        <source>Turn d&amp;art into seam</source>
        <translation>Abnäher in &amp;Naht umwandeln</translation>
    </message>
    <message>
        <source>Cut the selected dart from its tip to the edge to make a seam</source>
        <translation>Den ausgewählten Abnäher von der Spitze bis zur Kante zur Naht aufschneiden</translation>
    </message>
    <message>
        <source>Turn seam int&amp;o dart</source>
        <translation>Naht in Abnähe&amp;r umwandeln</translation>
    </message>
    <message>
        <source>Remove the cut that turned a dart into the selected seam</source>
        <translation>Den Einschnitt entfernen, der einen Abnäher zur ausgewählten Naht machte</translation>
    </message>
    <message>
        <source>Apply cuts and grain changes to both mirrored pieces if they are drawn equal</source>
        <translation>Einschnitte und Fadenlauf auf beide gespiegelten Schnittteile anwenden, wenn sie gleich gezeichnet sind</translation>
    </message>
    <message>
        <source>&amp;Position…</source>
        <translation>&amp;Position…</translation>
    </message>
    <message>
        <source>Set the position, angle and grain of the selected pieces</source>
        <translation>Position, Winkel und Fadenlauf der ausgewählten Schnittteile setzen</translation>
    </message>
    <message>
        <source>Choose the garment&apos;s fabric and set how far it stretches</source>
        <translation>Den Stoff des Kleidungsstücks wählen und festlegen, wie weit er sich dehnt</translation>
    </message>
    <message>
        <source>Show the list of pieces and give it the keyboard focus</source>
        <translation>Die Liste der Schnittteile zeigen und dorthin wechseln</translation>
    </message>
    <message>
        <source>Show the list of seams and give it the keyboard focus</source>
        <translation>Die Liste der Nähte zeigen und dorthin wechseln</translation>
    </message>
    <message>
        <source>Show problems to fix before cutting and give the list the keyboard focus</source>
        <translation>Probleme vor dem Zuschneiden zeigen und zu ihrer Liste wechseln</translation>
    </message>
    <message>
        <source>Show the list of your steps and give it the keyboard focus</source>
        <translation>Die Liste Ihrer Schritte zeigen und dorthin wechseln</translation>
    </message>
    <message>
        <source>Show the settings of pattern lines and give them the keyboard focus</source>
        <translation>Die Einstellungen der Schnittlinien zeigen und dorthin wechseln</translation>
    </message>
    <message>
        <source>Show which pieces mirror each other and give the panel the keyboard focus</source>
        <translation>Zeigen, welche Schnittteile einander spiegeln, und dorthin wechseln</translation>
    </message>
    <message>
        <source>Show the results of the proof and give the panel the keyboard focus</source>
        <translation>Die Ergebnisse der Nähprobe zeigen und dorthin wechseln</translation>
    </message>
    <message>
        <source>Restore the original arrangement of lists and panels</source>
        <translation>Die ursprüngliche Anordnung der Listen und Felder wiederherstellen</translation>
    </message>
    <message>
        <source>Choose units, colours, language and mouse controls</source>
        <translation>Einheiten, Farben, Sprache und Maussteuerung wählen</translation>
    </message>
    <message>
        <source>&amp;Find command…</source>
        <translation>&amp;Befehl suchen…</translation>
    </message>
    <message>
        <source>Type a few letters to find a command, a piece or a seam</source>
        <translation>Mit einigen Buchstaben einen Befehl, ein Schnittteil oder eine Naht finden</translation>
    </message>
    <message>
        <source>Make a pattern from a garment in five minutes</source>
        <translation>In fünf Minuten vom Kleidungsstück zum Schnitt</translation>
    </message>
    <message>
        <source>Read the manual of Toile</source>
        <translation>Das Handbuch zu Toile lesen</translation>
    </message>
    <message>
        <source>List all keys and mouse gestures</source>
        <translation>Alle Tasten und Mausgesten auflisten</translation>
    </message>
    <message>
        <source>See what to include in a report, with details of this computer</source>
        <translation>Zeigen, was in eine Meldung gehört, mit Angaben zu diesem Rechner</translation>
    </message>
    <message>
        <source>Show version, licence and purpose of Toile</source>
        <translation>Version, Lizenz und Zweck von Toile zeigen</translation>
    </message>
    <message>
        <source>In the garment view, as set in Preferences</source>
        <translation>In der Ansicht des Kleidungsstücks, wie in den Einstellungen gewählt</translation>
    </message>
    <message>
        <source>Turn the garment, unless the tool uses the drag</source>
        <translation>Das Kleidungsstück drehen, wenn das Werkzeug das Ziehen nicht braucht</translation>
    </message>
    <message>
        <source>Show the front, right side or top; with Ctrl the opposite side</source>
        <translation>Vorderseite, rechte Seite oder Oberseite zeigen; mit Strg die Gegenseite</translation>
    </message>
    <message>
        <source>Turn perspective on or off</source>
        <translation>Perspektive ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Move the view, unless the tool uses the keys</source>
        <translation>Die Ansicht verschieben, wenn das Werkzeug die Tasten nicht braucht</translation>
    </message>
    <message>
        <source>Show the commands for the piece, the seam or the selection</source>
        <translation>Die Befehle für Schnittteil, Naht oder Auswahl zeigen</translation>
    </message>
    <message>
        <source>Select the piece, the seam or, close to it, the vertex; on empty space: clear the selection</source>
        <translation>Das Schnittteil, die Naht oder aus der Nähe den Punkt auswählen; auf freier Fläche: die Auswahl aufheben</translation>
    </message>
    <message>
        <source>Add the piece to the selection or remove it</source>
        <translation>Das Schnittteil zur Auswahl hinzufügen oder daraus entfernen</translation>
    </message>
    <message>
        <source>Frame the piece; on an edge: select the edge from corner to corner; on empty space: frame everything</source>
        <translation>Das Schnittteil einpassen; auf einer Kante: sie von Ecke zu Ecke auswählen; auf freier Fläche: alles einpassen</translation>
    </message>
    <message>
        <source>Select everything in a box; with Ctrl or Shift: add it to the selection</source>
        <translation>Alles in einem Rahmen auswählen; mit Strg oder Umschalt: zur Auswahl hinzufügen</translation>
    </message>
    <message>
        <source>Toggle snapping</source>
        <translation>Das Einrasten umschalten</translation>
    </message>
    <message>
        <source>Cancel the drag</source>
        <translation>Das Ziehen abbrechen</translation>
    </message>
    <message>
        <source>Stop the running task; otherwise clear the selection</source>
        <translation>Den laufenden Vorgang anhalten; sonst die Auswahl aufheben</translation>
    </message>
    <message>
        <source>Set the next point; start on an edge to open the piece there</source>
        <translation>Den nächsten Punkt setzen; an einer Kante begonnen, öffnet der Einschnitt sie</translation>
    </message>
    <message>
        <source>Follow mesh edges to the pointer</source>
        <translation>Entlang der Netzkanten dorthin gehen</translation>
    </message>
    <message>
        <source>Cut around the tube there, before the first point</source>
        <translation>Rund um den Schlauch schneiden, vor dem ersten Punkt</translation>
    </message>
    <message>
        <source>Do not snap to edges and corners, after the first point</source>
        <translation>Nicht an Kanten und Ecken einrasten, nach dem ersten Punkt</translation>
    </message>
    <message>
        <source>Remove the last point</source>
        <translation>Den letzten Punkt entfernen</translation>
    </message>
    <message>
        <source>Discard the cut; without one: leave the tool</source>
        <translation>Den Einschnitt verwerfen; ohne einen: das Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Set the next point; at least three are needed</source>
        <translation>Den nächsten Punkt setzen; mindestens drei sind nötig</translation>
    </message>
    <message>
        <source>Cut out the part</source>
        <translation>Den Teil ausschneiden</translation>
    </message>
    <message>
        <source>Cut a dart to the end of the drag</source>
        <translation>Einen Abnäher bis zum Ende des Ziehens schneiden</translation>
    </message>
    <message>
        <source>Cut a dart with two clicks</source>
        <translation>Einen Abnäher mit zwei Klicks schneiden</translation>
    </message>
    <message>
        <source>Cut along mesh edges</source>
        <translation>Entlang der Netzkanten schneiden</translation>
    </message>
    <message>
        <source>Discard the dart; Esc without one: leave the tool</source>
        <translation>Den Abnäher verwerfen; Esc ohne einen: das Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Join the cloth on both sides of the seam</source>
        <translation>Den Stoff auf beiden Seiten der Naht verbinden</translation>
    </message>
    <message>
        <source>Leave the tool</source>
        <translation>Das Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Start measuring here, or measure on to the next point</source>
        <translation>Hier mit dem Messen beginnen oder zum nächsten Punkt weitermessen</translation>
    </message>
    <message>
        <source>End the measurement here</source>
        <translation>Die Messung hier beenden</translation>
    </message>
    <message>
        <source>Copy the measurement</source>
        <translation>Das Maß kopieren</translation>
    </message>
    <message>
        <source>Clear the measurement; without one: leave the tool</source>
        <translation>Das Maß löschen; ohne eines: das Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Cancel the drag; without one: leave the tool</source>
        <translation>Das Ziehen abbrechen; ohne eines: das Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Move the notch along its seam, on both sides</source>
        <translation>Den Knips entlang seiner Naht verschieben, auf beiden Seiten</translation>
    </message>
    <message>
        <source>Delete the notch</source>
        <translation>Den Knips löschen</translation>
    </message>
    <message>
        <source>End the line; a single point becomes a drill point</source>
        <translation>Die Linie beenden; ein einzelner Punkt wird ein Bohrpunkt</translation>
    </message>
    <message>
        <source>Delete the selected line</source>
        <translation>Die ausgewählte Linie löschen</translation>
    </message>
    <message>
        <source>Discard the line or cancel the drag; without either: leave the tool</source>
        <translation>Die Linie verwerfen oder das Ziehen abbrechen; ohne beides: das Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Show the commands for the piece or the seam</source>
        <translation>Die Befehle für Schnittteil oder Naht zeigen</translation>
    </message>
    <message>
        <source>Rename the piece</source>
        <translation>Das Schnittteil umbenennen</translation>
    </message>
    <message>
        <source>Loo&amp;k from</source>
        <translation>&amp;Blick</translation>
    </message>
    <message>
        <source>P&amp;anels</source>
        <translation>Fel&amp;der</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Ausr&amp;ichten</translation>
    </message>
    <message>
        <source>Tr&amp;eat file as</source>
        <translation>Date&amp;i lesen als</translation>
    </message>
    <message>
        <source>S&amp;plit pieces by</source>
        <translation>Schnittteile &amp;teilen nach</translation>
    </message>
    <message>
        <source>%1 x %2 pixels; the maximum is %3 dpi</source>
        <translation>%1 x %2 Pixel; höchstens %3 dpi möglich</translation>
    </message>
    <message>
        <source>How far the cloth can shrink without folds; 0 or less</source>
        <translation>Wie weit der Stoff ohne Falten schrumpfen kann; 0 oder weniger</translation>
    </message>
    <message>
        <source>Usable width from selvedge to selvedge</source>
        <translation>Breite von Webkante zu Webkante</translation>
    </message>
    <message>
        <source>The garment is %1 tall if the file is in %2 (largest extent %3). Is that right?</source>
        <translation>Das Kleidungsstück ist %1 hoch, wenn die Datei in %2 ist (größte Ausdehnung %3). Stimmt das?</translation>
    </message>
    <message>
        <source>Toile assumes that y points up, but it may be z. Which axis points up?</source>
        <translation>Toile nimmt an, dass y nach oben zeigt, es könnte aber z sein. Welche Achse zeigt nach oben?</translation>
    </message>
    <message>
        <source>Toile assumes that z points up, but it may be y. Which axis points up?</source>
        <translation>Toile nimmt an, dass z nach oben zeigt, es könnte aber y sein. Welche Achse zeigt nach oben?</translation>
    </message>
    <message>
        <source>The file is a closed shape: %1. It needs cuts before it can lie flat.</source>
        <translation>Die Datei ist eine geschlossene Form: %1. Sie braucht Einschnitte, bevor sie flach liegen kann.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Aufschneiden</translation>
    </message>
    <message>
        <source>Leave unchanged</source>
        <translation>Unverändert</translation>
    </message>
    <message>
        <source>This looks like half a garment: %1 of its rims lie in one plane. Add the mirror image?</source>
        <translation>Das sieht nach einem halben Kleidungsstück aus: %1 seiner Ränder liegen in einer Ebene. Das Spiegelbild ergänzen?</translation>
    </message>
    <message>
        <source>Complete</source>
        <translation>Ergänzen</translation>
    </message>
    <message>
        <source>The file may contain layers of cloth: %1. Which is it?</source>
        <translation>Die Datei enthält vielleicht Stofflagen: %1. Was trifft zu?</translation>
    </message>
    <message>
        <source>The file contains %1 layers of cloth: %2. Which layers do you want to cut?</source>
        <translation>Die Datei enthält %1 Stofflagen: %2. Welche Lagen möchten Sie zuschneiden?</translation>
    </message>
    <message>
        <source>The file is cloth with a thickness: %1. Which side is the pattern for?</source>
        <translation>Die Datei ist Stoff mit einer Dicke: %1. Für welche Seite ist der Schnitt?</translation>
    </message>
    <message>
        <source>The file looks like a scan: %1. Prepare it to remove debris, close small holes and smooth noise.</source>
        <translation>Die Datei sieht nach einem Scan aus: %1. Bereiten Sie ihn auf, um Bruchstücke zu entfernen, kleine Löcher zu schließen und Rauschen zu glätten.</translation>
    </message>
    <message>
        <source>Split by objects</source>
        <translation>Nach Objekten teilen</translation>
    </message>
    <message>
        <source>Split by groups</source>
        <translation>Nach Gruppen teilen</translation>
    </message>
    <message>
        <source>Split by materials</source>
        <translation>Nach Materialien teilen</translation>
    </message>
    <message>
        <source>Split by UV islands</source>
        <translation>Nach UV-Inseln teilen</translation>
    </message>
    <message>
        <source>Split by connected parts</source>
        <translation>Nach zusammenhängenden Teilen teilen</translation>
    </message>
    <message>
        <source>Split %1, only %2 of %3 pieces can lie flat. Split %4, %5 of %6 could.</source>
        <translation>%1 geteilt können nur %2 von %3 Schnittteilen flach liegen. %4 geteilt wären es %5 von %6.</translation>
    </message>
    <message>
        <source>%1, set by you</source>
        <translation>%1, von Ihnen gesetzt</translation>
    </message>
    <message>
        <source>y, set by you</source>
        <translation>y, von Ihnen gesetzt</translation>
    </message>
    <message>
        <source>z, set by you</source>
        <translation>z, von Ihnen gesetzt</translation>
    </message>
    <message>
        <source>Treated as</source>
        <translation>Gelesen als</translation>
    </message>
    <message>
        <source>Half a garment: Toile added the mirror image</source>
        <translation>Halbes Kleidungsstück: Toile hat das Spiegelbild ergänzt</translation>
    </message>
    <message>
        <source>no errors</source>
        <translation>keine Fehler</translation>
    </message>
    <message>
        <source>1 error</source>
        <translation>1 Fehler</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 Fehler</translation>
    </message>
    <message>
        <source>no warnings</source>
        <translation>keine Warnungen</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 Warnung</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 Warnungen</translation>
    </message>
    <message>
        <source>Copy a strip of this width along the segment as a separate piece; neighbouring segments share one facing</source>
        <translation>Einen Streifen dieser Breite entlang des Abschnitts als eigenes Schnittteil kopieren; benachbarte Abschnitte teilen sich einen Beleg</translation>
    </message>
    <message>
        <source>Open a project, or one or more files of a garment</source>
        <translation>Ein Projekt oder eine oder mehrere Dateien eines Kleidungsstücks öffnen</translation>
    </message>
    <message>
        <source>%1 x %2 mm are too large for a picture at any resolution</source>
        <translation>%1 x %2 mm sind für ein Bild in jeder Auflösung zu groß</translation>
    </message>
    <message>
        <source>each piece in its own colour</source>
        <translation>jedes Schnittteil in seiner eigenen Farbe</translation>
    </message>
    <message>
        <source>squares of 1 cm on the flat cloth</source>
        <translation>Quadrate von 1 cm auf dem flachen Stoff</translation>
    </message>
    <message>
        <source>3D against flat: orange stretches, blue has surplus</source>
        <translation>3D gegen flach: Orange dehnt sich, Blau hat zu viel</translation>
    </message>
    <message>
        <source>largest change of a triangle&apos;s corner angle</source>
        <translation>größte Änderung eines Winkels im Dreieck</translation>
    </message>
    <message>
        <source>mesh edges: orange stretches, blue has surplus</source>
        <translation>Netzkanten: Orange dehnt sich, Blau hat zu viel</translation>
    </message>
    <message>
        <source>%1 of the cloth has an edge beyond the tightest limit</source>
        <translation>%1 des Stoffes haben eine Kante jenseits der engsten Grenze</translation>
    </message>
    <message>
        <source>no edge is beyond the tightest limit</source>
        <translation>keine Kante liegt jenseits der engsten Grenze</translation>
    </message>
    <message>
        <source>along the grain: orange stretches, blue has surplus</source>
        <translation>im Fadenlauf: Orange dehnt sich, Blau hat zu viel</translation>
    </message>
    <message>
        <source>%1 of the cloth exceeds the warp limits</source>
        <translation>%1 des Stoffes liegen außerhalb der Grenzen der Kette</translation>
    </message>
    <message>
        <source>all cloth is within the warp limits</source>
        <translation>aller Stoff liegt in den Grenzen der Kette</translation>
    </message>
    <message>
        <source>across the grain: orange stretches, blue has surplus</source>
        <translation>quer zum Fadenlauf: Orange dehnt sich, Blau hat zu viel</translation>
    </message>
    <message>
        <source>%1 of the cloth exceeds the weft limits</source>
        <translation>%1 des Stoffes liegen außerhalb der Grenzen des Schusses</translation>
    </message>
    <message>
        <source>all cloth is within the weft limits</source>
        <translation>aller Stoff liegt in den Grenzen des Schusses</translation>
    </message>
    <message>
        <source>at 45° to the grain, the worse of both diagonals</source>
        <translation>unter 45° zum Fadenlauf, die schlechtere der beiden Diagonalen</translation>
    </message>
    <message>
        <source>%1 of the cloth exceeds the bias limits</source>
        <translation>%1 des Stoffes liegen außerhalb der Grenzen im schrägen Fadenlauf</translation>
    </message>
    <message>
        <source>all cloth is within the bias limits</source>
        <translation>aller Stoff liegt in den Grenzen im schrägen Fadenlauf</translation>
    </message>
    <message>
        <source>outward arrows stretch, inward arrows have surplus</source>
        <translation>Pfeile nach außen: Dehnung, Pfeile nach innen: zu viel</translation>
    </message>
    <message>
        <source>symmetric Dirichlet energy; 0 if the cloth keeps its shape</source>
        <translation>symmetrische Dirichlet-Energie; 0, wenn der Stoff seine Form behält</translation>
    </message>
    <message>
        <source>direction of the 3D surface, one colour for each axis</source>
        <translation>Richtung der 3D-Oberfläche, eine Farbe je Achse</translation>
    </message>
    <message>
        <source>sewn cloth against design: orange outside, blue inside</source>
        <translation>genähter Stoff gegen Entwurf: Orange außen, Blau innen</translation>
    </message>
    <message>
        <source>sewn cloth: orange pulls, blue is slack</source>
        <translation>genähter Stoff: Orange spannt, Blau ist lose</translation>
    </message>
    <message>
        <source>squares of 1/2 in on the flat cloth</source>
        <translation>Quadrate von 1/2 in auf dem flachen Stoff</translation>
    </message>
    <message>
        <source>%1 of the cloth exceeds the tightest limit</source>
        <translation>%1 des Stoffes liegen außerhalb der engsten Grenze</translation>
    </message>
    <message>
        <source>all cloth is within the tightest limit</source>
        <translation>aller Stoff liegt in der engsten Grenze</translation>
    </message>
</context>
<context>
    <name>toile::app::Banner</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>toile::app::BusySheet</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>toile::app::ClothView</name>
    <message>
        <source>Cloth</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Turn %1 on the cloth</source>
        <translation>%1 auf dem Stoff drehen</translation>
    </message>
    <message>
        <source>Keep %1 on the cloth</source>
        <translation>%1 auf dem Stoff festhalten</translation>
    </message>
    <message>
        <source>Release &amp;all</source>
        <translation>&amp;Alle loslassen</translation>
    </message>
    <message>
        <source>This marker allows only one direction. Change Direction first.</source>
        <translation>Dieses Schnittbild erlaubt nur eine Richtung. Ändern Sie zuerst „Richtung“.</translation>
    </message>
    <message>
        <source>Place %1 on the cloth</source>
        <translation>%1 auf den Stoff legen</translation>
    </message>
    <message>
        <source>&amp;Keep here</source>
        <translation>&amp;Hier festhalten</translation>
    </message>
    <message>
        <source>&amp;Release</source>
        <translation>&amp;Lösen</translation>
    </message>
    <message>
        <source>&amp;Turn by 90°</source>
        <translation>Um &amp;90° drehen</translation>
    </message>
    <message>
        <source>&amp;Turn by 180°</source>
        <translation>Um &amp;180° drehen</translation>
    </message>
    <message>
        <source>&amp;Show whole cloth</source>
        <translation>Den &amp;ganzen Stoff zeigen</translation>
    </message>
    <message>
        <source>%1 overlaps another piece or leaves the cloth</source>
        <translation>%1 überlappt ein anderes Teil oder ragt über den Stoff</translation>
    </message>
    <message>
        <source>%1 is placed by hand; double-click to release it</source>
        <translation>%1 ist von Hand gelegt; Doppelklick löst es</translation>
    </message>
</context>
<context>
    <name>toile::app::ColourBar</name>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>toile::app::ColourButton</name>
    <message>
        <source>Another colour…</source>
        <translation>Andere Farbe…</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
</context>
<context>
    <name>toile::app::CommandPalette</name>
    <message>
        <source>Type a command, a piece or a seam</source>
        <translation>Befehl, Schnittteil oder Naht eingeben</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Keine Treffer</translation>
    </message>
    <message>
        <source>Not available now: %1</source>
        <translation>Jetzt nicht verfügbar: %1</translation>
    </message>
</context>
<context>
    <name>toile::app::CompareWindow</name>
    <message>
        <source>Compare methods</source>
        <translation>Verfahren vergleichen</translation>
    </message>
    <message>
        <source>Figures of the methods</source>
        <translation>Zahlen der Verfahren</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Use this method</source>
        <translation>Dieses Verfahren nehmen</translation>
    </message>
    <message>
        <source>%1, the best</source>
        <translation>%1, der beste</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
    <message>
        <source>Waiting…</source>
        <translation>Wartet…</translation>
    </message>
    <message>
        <source>Flattening…</source>
        <translation>Wird abgewickelt…</translation>
    </message>
    <message>
        <source>%1, the flat piece</source>
        <translation>%1, das flache Schnittteil</translation>
    </message>
    <message>
        <source>★ best of its row. Seam Δ: the worst seam of the piece; its neighbours are flattened by the same method. Drag: move all pictures · Wheel: zoom · Double click: show everything</source>
        <translation>★ bester Wert der Zeile. Naht-Δ: schlechteste Naht des Schnittteils; angenähte Schnittteile sind nach demselben Verfahren abgewickelt. Ziehen: alle Bilder verschieben · Mausrad: Zoom · Doppelklick: alles zeigen</translation>
    </message>
    <message>
        <source>Pictures are not available: %1</source>
        <translation>Bilder sind nicht verfügbar: %1</translation>
    </message>
    <message>
        <source>Flatten the garment by this method</source>
        <translation>Das Kleidungsstück nach diesem Verfahren abwickeln</translation>
    </message>
</context>
<context>
    <name>toile::app::CutChart</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>all: %1</source>
        <translation>alle: %1</translation>
    </message>
    <message>
        <source>Strain by length of cuts</source>
        <translation>Dehnung nach Länge der Schnitte</translation>
    </message>
    <message>
        <source>no cuts</source>
        <translation>keine Schnitte</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Mean strain by length of cuts. Line: predicted; filled points: flattened</source>
        <translation>Mittlere Dehnung nach Länge der Schnitte. Linie: vorhergesagt; gefüllte Punkte: abgewickelt</translation>
    </message>
</context>
<context>
    <name>toile::app::CutEditor</name>
    <message>
        <source>Cut dart</source>
        <translation>Abnäher schneiden</translation>
    </message>
    <message>
        <source>Cut dart in %1</source>
        <translation>Abnäher in %1 schneiden</translation>
    </message>
    <message>
        <source>dart</source>
        <translation>Abnäher</translation>
    </message>
    <message>
        <source>Cut closed loop</source>
        <translation>Geschlossenen Schnitt schneiden</translation>
    </message>
    <message>
        <source>Cut closed loop in %1</source>
        <translation>Geschlossenen Schnitt in %1 schneiden</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Einschneiden</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Einschnitt in %1</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Remove cut</source>
        <translation>Einschnitt entfernen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>It is the mirror image of your cut. To cut one side only, switch off Tools ▸ Mirror edits.</source>
        <translation>Es ist das Spiegelbild Ihres Schnitts. Um nur eine Seite zu schneiden, schalten Sie Werkzeuge ▸ Änderungen spiegeln aus.</translation>
    </message>
    <message>
        <source>Load seams file</source>
        <translation>Nahtdatei laden</translation>
    </message>
    <message>
        <source>Finding the mirror image of a cut</source>
        <translation>Das Spiegelbild eines Schnitts wird gesucht</translation>
    </message>
    <message>
        <source>Cut on this side only: there is no mirror image, or a seam is there already.</source>
        <translation>Nur auf dieser Seite geschnitten: Es gibt kein Spiegelbild, oder dort ist schon eine Naht.</translation>
    </message>
    <message>
        <source>Cut on this side only: no mirror plane was found.</source>
        <translation>Nur auf dieser Seite geschnitten: Es wurde keine Spiegelebene gefunden.</translation>
    </message>
    <message>
        <source>%1 on both sides</source>
        <translation>%1 auf beiden Seiten</translation>
    </message>
    <message>
        <source>The garment changed before the cut was found. Cut again.</source>
        <translation>Das Kleidungsstück wurde geändert, bevor der Schnitt gefunden war. Schneiden Sie noch einmal.</translation>
    </message>
    <message>
        <source>Finding cuts</source>
        <translation>Schnitte werden gesucht</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Aufschneiden</translation>
    </message>
    <message>
        <source>Finding a closed loop</source>
        <translation>Ein geschlossener Schnitt wird gesucht</translation>
    </message>
    <message>
        <source>Turn dart in %1 into seam</source>
        <translation>Abnäher in %1 zur Naht machen</translation>
    </message>
    <message>
        <source>%1 cannot become a seam: its tip points at no edge of its piece.</source>
        <translation>%1 kann keine Naht werden: Die Spitze zeigt auf keine Kante des Schnittteils.</translation>
    </message>
    <message>
        <source>Turn %1 into dart</source>
        <translation>%1 zum Abnäher machen</translation>
    </message>
    <message>
        <source>%1 is a free edge, so it cannot be joined.</source>
        <translation>%1 ist eine freie Kante und lässt sich nicht verbinden.</translation>
    </message>
    <message>
        <source>%1 cannot be joined: Toile cut %2 open there so that it lies flat. Switch off Garment ▸ Cut open automatically, or draw your own cut.</source>
        <translation>%1 lässt sich nicht verbinden: Toile hat %2 dort aufgeschnitten, damit es flach liegt. Schalten Sie Kleidungsstück ▸ Von selbst aufschneiden aus, oder zeichnen Sie einen eigenen Schnitt.</translation>
    </message>
    <message>
        <source>Join %1</source>
        <translation>%1 verbinden</translation>
    </message>
    <message>
        <source>Remove join %1</source>
        <translation>Verbindung %1 entfernen</translation>
    </message>
</context>
<context>
    <name>toile::app::CutProposals</name>
    <message>
        <source>Cut along %1</source>
        <translation>Schnitt: %1</translation>
    </message>
    <message>
        <source>No cuts can be proposed for this piece. %1</source>
        <translation>Für dieses Schnittteil lassen sich keine Schnitte vorschlagen. %1</translation>
    </message>
    <message>
        <source>Make proposed cuts</source>
        <translation>Vorgeschlagene Schnitte ausführen</translation>
    </message>
</context>
<context>
    <name>toile::app::CutTool</name>
    <message>
        <source>Click: start the cut; on an edge, it opens there · Alt+click: cut around a tube · Ctrl+click: follow mesh edges · Esc: leave the tool</source>
        <translation>Klick: Einschnitt beginnen; an einer Kante öffnet er sie · Alt+Klick: rund um einen Schlauch schneiden · Strg+Klick: Netzkanten folgen · Esc: Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Click: next point · Alt: no snapping · Double click or Enter: cut · Backspace: remove the last point · Esc: discard the cut</source>
        <translation>Klick: nächster Punkt · Alt: nicht einrasten · Doppelklick oder Eingabe: einschneiden · Rücktaste: letzten Punkt entfernen · Esc: Einschnitt verwerfen</translation>
    </message>
    <message>
        <source>Click: next point · Alt: no snapping · Ctrl+click: follow mesh edges · Backspace: remove the point · Esc: discard the cut</source>
        <translation>Klick: nächster Punkt · Alt: nicht einrasten · Strg+Klick: Netzkanten folgen · Rücktaste: Punkt entfernen · Esc: Einschnitt verwerfen</translation>
    </message>
</context>
<context>
    <name>toile::app::CutsPanel</name>
    <message>
        <source>Cuts</source>
        <translation>Einschnitte</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Einschnitt</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>you</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>Toile</source>
        <translation>Toile</translation>
    </message>
    <message>
        <source>1 cut</source>
        <translation>1 Einschnitt</translation>
    </message>
    <message>
        <source>%1 cuts</source>
        <translation>%1 Einschnitte</translation>
    </message>
    <message>
        <source>you, joined</source>
        <translation>Sie, verbunden</translation>
    </message>
    <message>
        <source>1 join</source>
        <translation>1 Verbindung</translation>
    </message>
    <message>
        <source>%1 joins</source>
        <translation>%1 Verbindungen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>you, as proposed</source>
        <translation>Sie, wie vorgeschlagen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>%1: press Delete to remove it</source>
        <translation>%1: Entf entfernt ihn</translation>
    </message>
    <message>
        <source>%1 was joined: press Delete to restore the seam</source>
        <translation>%1 wurde verbunden: Entf stellt die Naht wieder her</translation>
    </message>
</context>
<context>
    <name>toile::app::DartForm</name>
    <message>
        <source>Ang&amp;le</source>
        <translation>Wi&amp;nkel</translation>
    </message>
    <message>
        <source>Legs %1 long</source>
        <translation>Schenkel %1 lang</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Intake as the angle between the legs at the tip.</source>
        <translation>Der Inhalt als Winkel zwischen den Schenkeln an der Spitze.</translation>
    </message>
    <message>
        <source>The legs are too short for this intake. Set it below %1.</source>
        <translation>Die Schenkel sind für diesen Inhalt zu kurz. Setzen Sie ihn unter %1.</translation>
    </message>
    <message>
        <source>The legs differ in length. Set the intake above %1.</source>
        <translation>Die Schenkel sind verschieden lang. Setzen Sie den Inhalt über %1.</translation>
    </message>
    <message>
        <source>A dart must open by less than 60°. Set the intake below %1.</source>
        <translation>Ein Abnäher muss sich um weniger als 60° öffnen. Setzen Sie den Inhalt unter %1.</translation>
    </message>
</context>
<context>
    <name>toile::app::DartTool</name>
    <message>
        <source>Enter: cut the proposed dart · Drag from an edge: draw another · Esc: discard the dart</source>
        <translation>Eingabe: den vorgeschlagenen Abnäher schneiden · Von einer Kante ziehen: einen anderen zeichnen · Esc: Abnäher verwerfen</translation>
    </message>
    <message>
        <source>Drag from an edge to the dart&apos;s tip, or click the edge and then the tip · Esc: leave the tool</source>
        <translation>Von einer Kante zur Spitze des Abnähers ziehen, oder die Kante und dann die Spitze anklicken · Esc: Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Click: tip of the dart · Ctrl+click: follow mesh edges · Backspace or Esc: discard the dart</source>
        <translation>Klick: Spitze des Abnähers · Strg+Klick: Netzkanten folgen · Rücktaste oder Esc: Abnäher verwerfen</translation>
    </message>
    <message>
        <source>a dart must start at an edge</source>
        <translation>ein Abnäher muss an einer Kante beginnen</translation>
    </message>
</context>
<context>
    <name>toile::app::Document</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Verfahren ändern</translation>
    </message>
    <message>
        <source>Set ease of %1</source>
        <translation>Einhalteweite von %1 setzen</translation>
    </message>
    <message>
        <source>Draw ease of %1</source>
        <translation>Einhalteweite von %1 zeichnen</translation>
    </message>
    <message>
        <source>Do not draw ease of %1</source>
        <translation>Einhalteweite von %1 nicht zeichnen</translation>
    </message>
</context>
<context>
    <name>toile::app::DocumentPage</name>
    <message>
        <source>Documentation</source>
        <translation>Dokumentation</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
</context>
<context>
    <name>toile::app::DrawingPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Drawing the pattern…</source>
        <translation>Schnitt wird gezeichnet…</translation>
    </message>
</context>
<context>
    <name>toile::app::ExportDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>Schnitt exportieren</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;File:</source>
        <translation>&amp;Datei:</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>D&amp;urchsuchen…</translation>
    </message>
    <message>
        <source>&amp;Show in folder</source>
        <translation>Im &amp;Ordner zeigen</translation>
    </message>
    <message>
        <source>For %1.</source>
        <translation>Für: %1.</translation>
    </message>
    <message>
        <source>%1 x %2 mm, %3</source>
        <translation>%1 x %2 mm, %3</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 Teil</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n Teile</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>1 page</source>
        <translation>1 Seite</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n Seiten</numerusform>
            <numerusform>%n Seiten</numerusform>
        </translation>
    </message>
    <message>
        <source>Start of the file</source>
        <translation>Anfang der Datei</translation>
    </message>
    <message>
        <source>Show the folder after writing the file.</source>
        <translation>Den Ordner nach dem Schreiben der Datei zeigen.</translation>
    </message>
</context>
<context>
    <name>toile::app::FabricPanel</name>
    <message>
        <source>&lt; %1 %</source>
        <translation>&lt; %1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>&amp;Fabric</source>
        <translation>&amp;Material</translation>
    </message>
    <message>
        <source>Stretches</source>
        <translation>Dehnt</translation>
    </message>
    <message>
        <source>Warp</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>Along the grain</source>
        <translation>Im Fadenlauf</translation>
    </message>
    <message>
        <source>Weft</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>Across the grain</source>
        <translation>Quer dazu</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Schräg</translation>
    </message>
    <message>
        <source>At 45° to the grain</source>
        <translation>Unter 45° dazu</translation>
    </message>
    <message>
        <source>Fabric &amp;of</source>
        <translation>Material v&amp;on</translation>
    </message>
    <message>
        <source>Fabric of</source>
        <translation>Material von</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>Open a garment to set its fabric.</source>
        <translation>Öffnen Sie ein Kleidungsstück, um seinen Stoff zu wählen.</translation>
    </message>
    <message>
        <source>The fabric of the garment.</source>
        <translation>Der Stoff des Kleidungsstücks.</translation>
    </message>
    <message>
        <source>No fabric set. Choose one to see where it is strained too far.</source>
        <translation>Kein Stoff gewählt. Wählen Sie einen, um zu sehen, wo er zu weit gedehnt wird.</translation>
    </message>
    <message>
        <source>Shrinks</source>
        <translation>Schrumpft</translation>
    </message>
    <message>
        <source>All strain is within the fabric&apos;s limits.</source>
        <translation>Alle Dehnungen liegen in den Grenzen des Stoffs.</translation>
    </message>
    <message>
        <source>The garment, or a material that you set for pieces.</source>
        <translation>Das Kleidungsstück oder eine Stoffart, die Sie für Schnittteile gesetzt haben.</translation>
    </message>
    <message>
        <source>Presets are rules of thumb. For exact limits, measure a sample and enter them.</source>
        <translation>Vorgaben sind Faustregeln. Für genaue Grenzen messen Sie eine Probe und tragen sie ein.</translation>
    </message>
    <message>
        <source>Box around one of each piece in this fabric, with allowances, grain upwards</source>
        <translation>Rahmen um je eines der Schnittteile aus diesem Stoff, mit Zugaben, Fadenlauf nach oben</translation>
    </message>
    <message>
        <source>Over the limits</source>
        <translation>Über den Grenzen</translation>
    </message>
    <message>
        <source>Share of the cloth strained beyond these limits, as shown at the overlay&apos;s colour bar</source>
        <translation>Anteil des Stoffs jenseits dieser Grenzen, wie am Farbbalken der Überlagerung</translation>
    </message>
    <message>
        <source>Show the strain in this direction</source>
        <translation>Die Dehnung in dieser Richtung zeigen</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebige</translation>
    </message>
    <message>
        <source>In at least one of the three directions. Edge strain differs: it applies the tightest limit to every edge.</source>
        <translation>In mindestens einer der drei Richtungen. Die Kantendehnung ist anders: Sie wendet auf jede Kante die engste Grenze an.</translation>
    </message>
    <message>
        <source>%1 at this width</source>
        <translation>%1 bei dieser Breite</translation>
    </message>
    <message>
        <source>The pieces are %1 wide, wider than the fabric</source>
        <translation>Die Schnittteile sind %1 breit, breiter als der Stoff</translation>
    </message>
    <message>
        <source>No flat pieces yet.</source>
        <translation>Noch keine flachen Schnittteile.</translation>
    </message>
    <message>
        <source>Worst: %1, %2 of its area</source>
        <translation>Am schlimmsten: %1, %2 seiner Fläche</translation>
    </message>
    <message>
        <source>Set fabric: %1</source>
        <translation>Stoff setzen: %1</translation>
    </message>
    <message>
        <source>Set fabric of %1: %2</source>
        <translation>Stoff von %1 setzen: %2</translation>
    </message>
    <message>
        <source>Set fabric limits</source>
        <translation>Grenzen des Stoffs setzen</translation>
    </message>
</context>
<context>
    <name>toile::app::GarmentActions</name>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Seams files (*.json)</source>
        <translation>Nahtdateien (*.json)</translation>
    </message>
    <message>
        <source>%1-pattern</source>
        <translation>%1-schnittmuster</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 spiegeln</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>&amp;Undo: Move proposed cut</source>
        <translation>&amp;Rückgängig: Vorgeschlagenen Schnitt verschieben</translation>
    </message>
    <message>
        <source>Projects open one at a time. Choose one project, or the meshes of one garment.</source>
        <translation>Projekte werden einzeln geöffnet. Wählen Sie ein Projekt oder die Netze eines Kleidungsstücks.</translation>
    </message>
    <message>
        <source>Proof reports (*.json)</source>
        <translation>Nähprobenberichte (*.json)</translation>
    </message>
    <message>
        <source>These pieces are horizontal and have no upward direction. Set their grain yourself.</source>
        <translation>Diese Schnittteile liegen waagerecht und haben keine Richtung nach oben. Setzen Sie den Fadenlauf selbst.</translation>
    </message>
    <message>
        <source>Set grain of %1</source>
        <translation>Fadenlauf von %1 setzen</translation>
    </message>
    <message>
        <source>Best grain for woven fabric: no fabric is set</source>
        <translation>Bester Fadenlauf wie für Webstoff: Es ist kein Stoff gewählt</translation>
    </message>
    <message>
        <source>Best grain: turning does not help; %1 % of the cloth exceeds the fabric&apos;s limits</source>
        <translation>Bester Fadenlauf: Drehen hilft nicht; %1 % des Stoffs überschreiten seine Grenzen</translation>
    </message>
    <message>
        <source>Best grain: %1 % of the cloth exceeds the fabric&apos;s limits, %2 % before</source>
        <translation>Bester Fadenlauf: %1 % des Stoffs überschreiten seine Grenzen, vorher %2 %</translation>
    </message>
    <message>
        <source>Pieces or fabric changed while the grain was being computed. Run the command again.</source>
        <translation>Schnittteile oder Stoff haben sich während der Berechnung des Fadenlaufs geändert. Führen Sie den Befehl noch einmal aus.</translation>
    </message>
    <message>
        <source>Reset grain of %1</source>
        <translation>Fadenlauf von %1 zurücksetzen</translation>
    </message>
    <message>
        <source>Use body as dress form</source>
        <translation>Auf einem Körper nähen</translation>
    </message>
</context>
<context>
    <name>toile::app::GarmentCard</name>
    <message>
        <source>%1 and %2 differ by %3 (tolerance %4).</source>
        <translation>%1 und %2 unterscheiden sich um %3 (Toleranz %4).</translation>
    </message>
    <message>
        <source>The two halves of %1 are not equal.</source>
        <translation>Die beiden Hälften von %1 sind nicht gleich.</translation>
    </message>
    <message>
        <source>%1 and %2 are not equal.</source>
        <translation>%1 und %2 sind nicht gleich.</translation>
    </message>
    <message>
        <source>Make mirrored pieces equal</source>
        <translation>Gespiegelte Schnittteile gleich machen</translation>
    </message>
    <message>
        <source>Make equal</source>
        <translation>Gleich machen</translation>
    </message>
    <message>
        <source>Keep as in the file</source>
        <translation>Wie in der Datei lassen</translation>
    </message>
    <message>
        <source>One more piece or pair differs by less.</source>
        <translation>Ein weiteres Schnittteil oder Paar unterscheidet sich weniger.</translation>
    </message>
    <message>
        <source>%1 more pieces or pairs differ by less.</source>
        <translation>%1 weitere Schnittteile oder Paare unterscheiden sich weniger.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Confirm these guesses and stop asking about this garment</source>
        <translation>Diese Annahmen bestätigen und zu diesem Kleidungsstück nicht mehr fragen</translation>
    </message>
</context>
<context>
    <name>toile::app::GarmentView</name>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
</context>
<context>
    <name>toile::app::GrainTool</name>
    <message>
        <source>Turn the grain in the pattern view · Esc: leave the tool</source>
        <translation>Den Fadenlauf in der Schnittansicht drehen · Esc: Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Drag: turn the grain · Alt: toggle snapping · Esc: cancel</source>
        <translation>Ziehen: Fadenlauf drehen · Alt: Einrasten umkehren · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Drag on a piece: turn its grain · Alt: toggle snapping · Click: select · Esc: leave the tool</source>
        <translation>Auf einem Schnittteil ziehen: seinen Fadenlauf drehen · Alt: Einrasten umkehren · Klick: auswählen · Esc: Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Turn grain of %1</source>
        <translation>Fadenlauf von %1 drehen</translation>
    </message>
</context>
<context>
    <name>toile::app::HelpPage</name>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Tastatur und Maus</translation>
    </message>
    <message>
        <source>Search for a key or a command</source>
        <translation>Taste oder Befehl suchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Keine Treffer</translation>
    </message>
</context>
<context>
    <name>toile::app::InternalLineTool</name>
    <message>
        <source>line %1</source>
        <translation>Linie %1</translation>
    </message>
    <message>
        <source>drill point %1</source>
        <translation>Bohrpunkt %1</translation>
    </message>
    <message>
        <source>Drag: move the point · Esc: cancel</source>
        <translation>Ziehen: den Punkt verschieben · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Click: start a line · Click a line: select it · Drag a point: move it · Del: delete the line · Esc: leave the tool</source>
        <translation>Klick: eine Linie beginnen · Klick auf eine Linie: sie auswählen · Einen Punkt ziehen: ihn verschieben · Entf: die Linie löschen · Esc: Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Click: next point · Double click or Enter: end the line · Backspace: remove the last point · Esc: discard the line</source>
        <translation>Klick: nächster Punkt · Doppelklick oder Eingabe: die Linie beenden · Rücktaste: den letzten Punkt entfernen · Esc: die Linie verwerfen</translation>
    </message>
    <message>
        <source>Click: next point · Click the first point: close the line · Double click or Enter: end it · Backspace: remove the last point · Esc: discard the line</source>
        <translation>Klick: nächster Punkt · Klick auf den ersten Punkt: die Linie schließen · Doppelklick oder Eingabe: sie beenden · Rücktaste: den letzten Punkt entfernen · Esc: die Linie verwerfen</translation>
    </message>
    <message>
        <source>a line must stay on one piece</source>
        <translation>eine Linie muss auf einem Schnittteil bleiben</translation>
    </message>
    <message>
        <source>Move internal line</source>
        <translation>Innenlinie verschieben</translation>
    </message>
    <message>
        <source>Add internal line</source>
        <translation>Innenlinie hinzufügen</translation>
    </message>
    <message>
        <source>Delete internal line</source>
        <translation>Innenlinie löschen</translation>
    </message>
</context>
<context>
    <name>toile::app::JoinTool</name>
    <message>
        <source>Click a seam: join the cloth on both sides · Esc: leave the tool</source>
        <translation>Naht anklicken: den Stoff auf beiden Seiten verbinden · Esc: Werkzeug verlassen</translation>
    </message>
</context>
<context>
    <name>toile::app::LeaveOutDialog</name>
    <message>
        <source>Leave out small pieces</source>
        <translation>Kleine Schnittteile ausnehmen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source> cm²</source>
        <translation> cm²</translation>
    </message>
    <message>
        <source>Pieces &amp;below</source>
        <translation>Schnittteile &amp;unter</translation>
    </message>
    <message>
        <source>&amp;Leave out</source>
        <translation>Ausneh&amp;men</translation>
    </message>
    <message>
        <source>%1 of %2 pieces: %3</source>
        <translation>%1 von %2 Schnittteilen: %3</translation>
    </message>
    <message>
        <source>No piece is smaller than this.</source>
        <translation>Kein Schnittteil ist kleiner.</translation>
    </message>
</context>
<context>
    <name>toile::app::LinesPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>True seam end</source>
        <translation>Nahtende ausgleichen</translation>
    </message>
    <message>
        <source>Keep kink at seam end</source>
        <translation>Knick am Nahtende lassen</translation>
    </message>
    <message>
        <source>Put today&apos;s date on the labels</source>
        <translation>Das heutige Datum auf die Etiketten setzen</translation>
    </message>
    <message>
        <source>At most %1 from the exact outline. The largest strain changes from %2 to %3.</source>
        <translation>Höchstens %1 vom genauen Umriss. Die größte Dehnung ändert sich von %2 auf %3.</translation>
    </message>
    <message>
        <source>All lines follow the exact outline.</source>
        <translation>Alle Linien folgen dem genauen Umriss.</translation>
    </message>
</context>
<context>
    <name>toile::app::LoopTool</name>
    <message>
        <source>Click: start a closed cut · Alt+click: cut around a tube · Ctrl+click: follow mesh edges · Esc: leave the tool</source>
        <translation>Klick: geschlossenen Schnitt beginnen · Alt+Klick: rund um einen Schlauch schneiden · Strg+Klick: Netzkanten folgen · Esc: Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Click: next point · Click the first point, double click or Enter: cut · Backspace: remove the last point · Esc: discard the cut</source>
        <translation>Klick: nächster Punkt · Klick auf den ersten Punkt, Doppelklick oder Eingabe: schneiden · Rücktaste: letzten Punkt entfernen · Esc: Schnitt verwerfen</translation>
    </message>
    <message>
        <source>Click: next point (three or more) · Backspace: remove the last point · Esc: discard the cut</source>
        <translation>Klick: nächster Punkt (drei oder mehr) · Rücktaste: letzten Punkt entfernen · Esc: Schnitt verwerfen</translation>
    </message>
</context>
<context>
    <name>toile::app::MainWindow</name>
    <message>
        <source>Toile</source>
        <translation>Toile</translation>
    </message>
    <message>
        <source>%1[*] – Toile</source>
        <translation>%1[*] – Toile</translation>
    </message>
    <message>
        <source>Right-click the place for the dart, or mark the worst spots first.</source>
        <translation>Klicken Sie mit der rechten Taste auf die Stelle für den Abnäher, oder markieren Sie zuerst die schlimmsten Stellen.</translation>
    </message>
    <message>
        <source>Large garment: press %1 to flatten your edits</source>
        <translation>Großes Kleidungsstück: %1 drücken, um Ihre Änderungen abzuwickeln</translation>
    </message>
    <message>
        <source>Unsaved changes are not backed up: %1</source>
        <translation>Ungespeicherte Änderungen werden nicht gesichert: %1</translation>
    </message>
</context>
<context>
    <name>toile::app::MarkerDesk</name>
    <message>
        <source>Open a garment first.</source>
        <translation>Öffnen Sie zuerst ein Kleidungsstück.</translation>
    </message>
    <message>
        <source>Release %1 on the cloth</source>
        <translation>%1 auf dem Stoff loslassen</translation>
    </message>
    <message>
        <source>The pattern is out of date. Use Flatten &gt; Flatten again.</source>
        <translation>Der Schnitt ist veraltet. Wählen Sie Abwickeln &gt; Neu abwickeln.</translation>
    </message>
    <message>
        <source>There are no flat pieces. Use Flatten &gt; Flatten again, or cut the pieces that cannot lie flat.</source>
        <translation>Es gibt keine flachen Schnittteile. Wählen Sie Abwickeln &gt; Neu abwickeln, oder schneiden Sie Teile ein, die nicht flach liegen können.</translation>
    </message>
    <message>
        <source>Waiting for the pattern…</source>
        <translation>Warten auf den Schnitt …</translation>
    </message>
    <message>
        <source>The search stopped before it applied your settings. Press Start again.</source>
        <translation>Die Suche endete, bevor Ihre Einstellungen angewandt waren. Drücken Sie „Neu beginnen“.</translation>
    </message>
    <message>
        <source>Placing the pieces…</source>
        <translation>Die Teile werden gelegt …</translation>
    </message>
    <message>
        <source>Release all pieces on the cloth</source>
        <translation>Alle Teile auf dem Stoff lösen</translation>
    </message>
</context>
<context>
    <name>toile::app::MarkerForm</name>
    <message>
        <source>Cloth</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>Stoff&amp;art</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Hides…</source>
        <translation>Häute …</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Stripes and plaids</source>
        <translation>Streifen und Karos</translation>
    </message>
    <message>
        <source>Seams that match</source>
        <translation>Nähte, an denen der Rapport passt</translation>
    </message>
    <message>
        <source>Match stripes &amp;across</source>
        <translation>Rapport p&amp;asst an</translation>
    </message>
    <message>
        <source>&amp;Fabric form</source>
        <translation>Sto&amp;ffform</translation>
    </message>
    <message>
        <source>Garment&apos;s fabric</source>
        <translation>Eigener Stoff</translation>
    </message>
    <message>
        <source>Each material has its own marker. Set the material of a piece in the panel Properties</source>
        <translation>Jede Stoffart hat ein eigenes Schnittbild. Die Stoffart eines Teils setzen Sie im Bereich Eigenschaften</translation>
    </message>
    <message>
        <source>A roll, sheets of one size, or hides from DXF or SVG files. The largest line is the edge, inner lines are holes, or zones on layers like &quot;grade 2&quot;</source>
        <translation>Eine Rolle, Bögen einer Größe oder Häute aus DXF- oder SVG-Dateien. Die größte Linie ist der Rand, innere Linien sind Löcher, oder Zonen auf Ebenen wie „grade 2“</translation>
    </message>
    <message>
        <source>The repeat continues across the checked seams; seams where it cannot are listed below</source>
        <translation>Der Rapport geht über die angekreuzten Nähte hinweg; Nähte, an denen das nicht möglich ist, stehen unten</translation>
    </message>
    <message>
        <source>Change fabric form</source>
        <translation>Stoffform ändern</translation>
    </message>
</context>
<context>
    <name>toile::app::MarkerWindow</name>
    <message>
        <source>Start a&amp;gain</source>
        <translation>&amp;Neu beginnen</translation>
    </message>
    <message>
        <source>Sa&amp;ve marker…</source>
        <translation>Schnittbild &amp;sichern …</translation>
    </message>
    <message>
        <source> min/m</source>
        <translation> min/m</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>&amp;Improve</source>
        <translation>&amp;Verbessern</translation>
    </message>
    <message>
        <source>1 sheet, %1 % used</source>
        <translation>1 Bogen, %1 % genutzt</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets, %1 % used</source>
        <translation>
            <numerusform>%n Bogen, %1 % genutzt</numerusform>
            <numerusform>%n Bögen, %1 % genutzt</numerusform>
        </translation>
    </message>
    <message>
        <source>1 hide, %1 % used</source>
        <translation>1 Haut, %1 % genutzt</translation>
    </message>
    <message numerus="yes">
        <source>%n hides, %1 % used</source>
        <translation>
            <numerusform>%n Haut, %1 % genutzt</numerusform>
            <numerusform>%n Häute, %1 % genutzt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of cloth, folded to %2, %3 % used</source>
        <translation>%1 Stoff, gefaltet auf %2, %3 % genutzt</translation>
    </message>
    <message>
        <source>%1 of cloth, %2 wide, %3 % used</source>
        <translation>%1 Stoff, %2 breit, %3 % genutzt</translation>
    </message>
    <message>
        <source>1 piece</source>
        <translation>1 Teil</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 to cut</source>
        <translation>%1 zuzuschneiden</translation>
    </message>
    <message>
        <source>1 notch</source>
        <translation>1 Knips</translation>
    </message>
    <message numerus="yes">
        <source>%n notches</source>
        <translation>
            <numerusform>%n Knips</numerusform>
            <numerusform>%n Knipse</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of seams: %2 min at</source>
        <translation>%1 Nähte: %2 min bei</translation>
    </message>
    <message>
        <source>%1-marker</source>
        <translation>%1-schnittbild</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Schnittbild</translation>
    </message>
    <message>
        <source>Your sewing time per metre of seam</source>
        <translation>Ihre Nähzeit je Meter Naht</translation>
    </message>
    <message>
        <source>Minutes per metre of seam</source>
        <translation>Minuten je Meter Naht</translation>
    </message>
    <message>
        <source>Discard the result and search again; pieces placed by hand stay</source>
        <translation>Das Ergebnis verwerfen und neu suchen; von Hand gelegte Teile bleiben</translation>
    </message>
    <message>
        <source>Save the marker as PDF, SVG, DXF, PLT or PNG</source>
        <translation>Das Schnittbild als PDF, SVG, DXF, PLT oder PNG sichern</translation>
    </message>
    <message>
        <source>Stop and keep the best marker found</source>
        <translation>Anhalten und das beste Schnittbild behalten</translation>
    </message>
    <message>
        <source>Search for a shorter marker until you stop</source>
        <translation>Ein kürzeres Schnittbild suchen, bis Sie anhalten</translation>
    </message>
    <message>
        <source>First move the red pieces so that none overlaps or leaves the cloth</source>
        <translation>Verschieben Sie zuerst die roten Teile, bis keines überlappt oder über den Stoff ragt</translation>
    </message>
    <message>
        <source>The search has not applied your settings yet</source>
        <translation>Die Suche hat Ihre Einstellungen noch nicht angewandt</translation>
    </message>
    <message>
        <source>1 piece overlaps another or leaves the cloth</source>
        <translation>1 Teil überlappt ein anderes oder ragt über den Stoff</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces overlap others or leave the cloth</source>
        <translation>
            <numerusform>%n Teil überlappt ein anderes oder ragt über den Stoff</numerusform>
            <numerusform>%n Teile überlappen andere oder ragen über den Stoff</numerusform>
        </translation>
    </message>
    <message>
        <source>1 search round</source>
        <translation>1 Suchrunde</translation>
    </message>
    <message numerus="yes">
        <source>%n search rounds</source>
        <translation>
            <numerusform>%n Suchrunde</numerusform>
            <numerusform>%n Suchrunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose hides</source>
        <translation>Häute wählen</translation>
    </message>
    <message>
        <source>Choose a file name that ends in .pdf, .svg, .dxf, .plt or .png.</source>
        <translation>Wählen Sie einen Dateinamen, der auf .pdf, .svg, .dxf, .plt oder .png endet.</translation>
    </message>
    <message>
        <source>Not saved: the marker changed meanwhile. Save it again.</source>
        <translation>Nicht gesichert: Das Schnittbild hat sich inzwischen geändert. Sichern Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gesichert: %1</translation>
    </message>
</context>
<context>
    <name>toile::app::MaterialMenu</name>
    <message>
        <source>New material</source>
        <translation>Neue Stoffart</translation>
    </message>
    <message>
        <source>Cut the selected pieces from this material</source>
        <translation>Die ausgewählten Schnittteile aus dieser Stoffart zuschneiden</translation>
    </message>
    <message>
        <source>Garment&apos;s &amp;fabric</source>
        <translation>Sto&amp;ff des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Material of %1:</source>
        <translation>Stoffart von %1:</translation>
    </message>
</context>
<context>
    <name>toile::app::MeasureTool</name>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>+%1 %</source>
        <translation>+%1 %</translation>
    </message>
    <message>
        <source>−%1 %</source>
        <translation>−%1 %</translation>
    </message>
    <message>
        <source>%1: %2, not flat yet</source>
        <translation>%1: %2, noch nicht flach</translation>
    </message>
    <message>
        <source>%1: %2, flat %3 (%4)</source>
        <translation>%1: %2, flach %3 (%4)</translation>
    </message>
    <message>
        <source>On the cloth</source>
        <translation>Auf dem Stoff</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>An der Kante</translation>
    </message>
    <message>
        <source>Click: start measuring · Esc: leave the tool · two points on an edge are also measured along it</source>
        <translation>Klick: Messung beginnen · Esc: Werkzeug verlassen · Zwei Punkte auf einer Kante werden auch an ihr entlang gemessen</translation>
    </message>
    <message>
        <source>Click: new measurement · Ctrl+C: copy · Esc: clear it</source>
        <translation>Klick: neue Messung · Strg+C: kopieren · Esc: Maß löschen</translation>
    </message>
    <message>
        <source>Click: next point · Double click or Enter: end here · Backspace: remove the last point · Ctrl+C: copy · Esc: clear the measurement</source>
        <translation>Klick: nächster Punkt · Doppelklick oder Eingabe: hier enden · Rücktaste: letzten Punkt entfernen · Strg+C: kopieren · Esc: Maß löschen</translation>
    </message>
</context>
<context>
    <name>toile::app::MenuPlace</name>
    <message>
        <source>Seam lines keep their length</source>
        <translation>Nahtlinien behalten ihre Länge</translation>
    </message>
    <message>
        <source>Seam lines may change length</source>
        <translation>Nahtlinien dürfen ihre Länge ändern</translation>
    </message>
</context>
<context>
    <name>toile::app::MirroredPiecesList</name>
    <message>
        <source>Mirrored pieces</source>
        <translation>Gespiegelte Schnittteile</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>Differ by</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>Half only</source>
        <translation>Nur halb</translation>
    </message>
    <message>
        <source>%1 and %2 mirror each other</source>
        <translation>%1 und %2 spiegeln einander</translation>
    </message>
    <message>
        <source>cut 1 pair</source>
        <translation>1 Paar zuschneiden</translation>
    </message>
    <message>
        <source>cut on the fold</source>
        <translation>im Bruch zuschneiden</translation>
    </message>
    <message>
        <source>no counterpart</source>
        <translation>kein Gegenstück</translation>
    </message>
    <message>
        <source>equal</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>other segments</source>
        <translation>andere Abschnitte</translation>
    </message>
    <message>
        <source>not flat</source>
        <translation>nicht flach</translation>
    </message>
    <message>
        <source>Only flat pieces are drawn</source>
        <translation>Nur flache Schnittteile werden gezeichnet</translation>
    </message>
    <message>
        <source>not drawn</source>
        <translation>nicht gezeichnet</translation>
    </message>
    <message>
        <source>One half of the line is the mirror image of the other</source>
        <translation>Eine Hälfte der Linie ist das Spiegelbild der anderen</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>Two pieces that mirror each other, or one symmetric piece</source>
        <translation>Zwei Schnittteile, die einander spiegeln, oder ein symmetrisches</translation>
    </message>
    <message>
        <source>Root mean square distance between a piece and the other&apos;s mirror image</source>
        <translation>Quadratisches Mittel des Abstands zwischen einem Schnittteil und dem Spiegelbild des anderen</translation>
    </message>
    <message>
        <source>How the pattern draws the pieces</source>
        <translation>Wie der Schnitt die Schnittteile zeichnet</translation>
    </message>
    <message>
        <source>Draw only one piece of a pair, or one half of a piece to cut on the fold</source>
        <translation>Nur ein Schnittteil eines Paars zeichnen, oder eine Hälfte zum Zuschneiden im Stoffbruch</translation>
    </message>
    <message>
        <source>%1 is symmetric</source>
        <translation>%1 ist symmetrisch</translation>
    </message>
    <message>
        <source>Only pieces that are drawn equal can be halved</source>
        <translation>Nur gleich gezeichnete Schnittteile lassen sich halbieren</translation>
    </message>
    <message>
        <source>No other piece mirrors this one, and it is not symmetric</source>
        <translation>Kein anderes Schnittteil spiegelt dieses, und es ist nicht symmetrisch</translation>
    </message>
    <message>
        <source>%1 and %2 differ by %3, more than the tolerance of %4, so both keep their shapes</source>
        <translation>%1 und %2 unterscheiden sich um %3, mehr als die Toleranz von %4. Beide behalten ihre Form</translation>
    </message>
    <message>
        <source>The segments of the two outlines are in a different order, so each keeps its line</source>
        <translation>Die Abschnitte der beiden Umrisse sind verschieden geordnet. Jeder behält seine Linie</translation>
    </message>
    <message>
        <source>No common line was found, so each keeps its own</source>
        <translation>Keine gemeinsame Linie gefunden. Jeder behält seine eigene</translation>
    </message>
    <message>
        <source>Both use the line of %1</source>
        <translation>Beide verwenden die Linie von %1</translation>
    </message>
    <message>
        <source>Both use the mean of their lines</source>
        <translation>Beide verwenden das Mittel ihrer Linien</translation>
    </message>
</context>
<context>
    <name>toile::app::MorphBar</name>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>From garment to pattern</source>
        <translation>Vom Kleidungsstück zum Schnittmuster</translation>
    </message>
    <message>
        <source>Go from the 3D garment (left) to the flat pattern (right)</source>
        <translation>Vom 3D-Kleidungsstück (links) zum flachen Schnitt (rechts)</translation>
    </message>
    <message>
        <source>Play from garment to pattern and back</source>
        <translation>Vom Kleidungsstück zum Schnittmuster und zurück abspielen</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
</context>
<context>
    <name>toile::app::NotchTool</name>
    <message>
        <source>Drag: move the notch along its seam · Esc: cancel</source>
        <translation>Ziehen: den Knips entlang seiner Naht verschieben · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Click a seam: add a notch · Drag a notch: move it · Ctrl+click or Del: delete it · Esc: leave the tool</source>
        <translation>Naht anklicken: Knips setzen · Knips ziehen: verschieben · Strg+Klick oder Entf: löschen · Esc: Werkzeug verlassen</translation>
    </message>
    <message>
        <source>Move notch</source>
        <translation>Knips verschieben</translation>
    </message>
    <message>
        <source>Add notch</source>
        <translation>Knips setzen</translation>
    </message>
    <message>
        <source>Delete notch</source>
        <translation>Knips löschen</translation>
    </message>
</context>
<context>
    <name>toile::app::OutdatedBar</name>
    <message>
        <source>The pattern is out of date</source>
        <translation>Der Schnitt ist veraltet</translation>
    </message>
    <message>
        <source>Flatten now</source>
        <translation>Jetzt abwickeln</translation>
    </message>
    <message>
        <source>Flatten the pieces that edits have changed</source>
        <translation>Die Schnittteile abwickeln, die sich geändert haben</translation>
    </message>
    <message>
        <source>The pattern is out of date. Flatten it first</source>
        <translation>Der Schnitt ist veraltet. Erst abwickeln</translation>
    </message>
</context>
<context>
    <name>toile::app::OverlayButtons</name>
    <message>
        <source>Overlay</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>Colours shown on the cloth in both views</source>
        <translation>Farben auf dem Stoff in beiden Ansichten</translation>
    </message>
</context>
<context>
    <name>toile::app::PathTool</name>
    <message>
        <source>a cut must stay on one piece</source>
        <translation>ein Einschnitt muss auf einem Schnittteil bleiben</translation>
    </message>
    <message>
        <source>much longer than a straight line; check the layer</source>
        <translation>viel länger als gerade; ist es die richtige Lage?</translation>
    </message>
</context>
<context>
    <name>toile::app::PatternPrinting</name>
    <message>
        <source>Printing the pattern</source>
        <translation>Schnitt wird gedruckt</translation>
    </message>
    <message>
        <source>Printed: %1</source>
        <translation>Gedruckt: %1</translation>
    </message>
    <message>
        <source>The printer&apos;s margins are wider than the pattern&apos;s, so lines at the edges would be missing. Choose another page: the one that fits A4 and Letter has the widest margins.</source>
        <translation>Die Ränder des Druckers sind breiter als die des Schnitts, am Rand würden Linien fehlen. Wählen Sie eine andere Seite: Die Seite für A4 und Letter hat die breitesten Ränder.</translation>
    </message>
    <message>
        <source>The printer&apos;s page is %1, but the pattern&apos;s pages are %2 and cannot be scaled down. Choose another page here or larger paper for the printer.</source>
        <translation>Die Seite des Druckers ist %1 groß, die Seiten des Schnitts aber %2, und sie werden nie verkleinert. Wählen Sie hier eine andere Seite oder für den Drucker größeres Papier.</translation>
    </message>
    <message>
        <source>%1 does not accept the print job. Check that it is switched on, or print a PDF file from another program.</source>
        <translation>%1 nimmt den Druckauftrag nicht an. Prüfen Sie, ob er eingeschaltet ist, oder drucken Sie eine PDF-Datei aus einem anderen Programm.</translation>
    </message>
</context>
<context>
    <name>toile::app::PatternView</name>
    <message>
        <source>Pattern</source>
        <translation>Schnittmuster</translation>
    </message>
</context>
<context>
    <name>toile::app::PercentEdit</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>toile::app::PieceChoice</name>
    <message>
        <source>Pieces</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>All pieces</source>
        <translation>Alle Schnittteile</translation>
    </message>
    <message>
        <source>Selected pieces (%1)</source>
        <translation>Ausgewählte Schnittteile (%1)</translation>
    </message>
    <message>
        <source>Pieces to include</source>
        <translation>Schnittteile, die enthalten sind</translation>
    </message>
</context>
<context>
    <name>toile::app::PieceForm</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paar</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Stoffart</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Fadenlauf</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>&amp;Quantity</source>
        <translation>A&amp;nzahl</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>&amp;Stoffart</translation>
    </message>
    <message>
        <source>&amp;Grain</source>
        <translation>&amp;Fadenlauf</translation>
    </message>
    <message>
        <source>No piece selected</source>
        <translation>Kein Schnittteil ausgewählt</translation>
    </message>
    <message>
        <source>grain not set</source>
        <translation>Fadenlauf nicht angegeben</translation>
    </message>
    <message>
        <source>Name of the piece; empty: the name in the file</source>
        <translation>Name des Schnittteils; leer: der Name in der Datei</translation>
    </message>
    <message>
        <source>Size of the cut piece: across the grain × along the grain</source>
        <translation>Größe des zugeschnittenen Teils: quer × längs zum Fadenlauf</translation>
    </message>
    <message>
        <source>Number of copies to cut</source>
        <translation>Wie oft das Schnittteil zugeschnitten wird</translation>
    </message>
    <message>
        <source>Also cut a mirrored copy of each: left and right</source>
        <translation>Jedes auch gespiegelt zuschneiden: links und rechts</translation>
    </message>
    <message>
        <source>Material of the selected pieces; empty: garment&apos;s fabric</source>
        <translation>Stoffart der ausgewählten Schnittteile; leer: Stoff des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Direction of the warp: 90° is upwards</source>
        <translation>Richtung der Kette: 90° zeigt nach oben</translation>
    </message>
    <message>
        <source>garment&apos;s fabric</source>
        <translation>Stoff des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Set grain of %1</source>
        <translation>Fadenlauf von %1 setzen</translation>
    </message>
</context>
<context>
    <name>toile::app::PiecesModel</name>
    <message>
        <source>Not flat: %1</source>
        <translation>Nicht flach: %1</translation>
    </message>
    <message>
        <source>Partly flipped</source>
        <translation>Teils umgeklappt</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Name of the piece and its colour in the views</source>
        <translation>Name des Schnittteils und seine Farbe in den Ansichten</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Area %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>Area of the flat piece</source>
        <translation>Fläche des flachen Schnittteils</translation>
    </message>
    <message>
        <source>Outline %1</source>
        <translation>Umriss %1</translation>
    </message>
    <message>
        <source>Outline error %</source>
        <translation>Umrissfehler %</translation>
    </message>
    <message>
        <source>Mean strain %</source>
        <translation>Mittlere Dehnung %</translation>
    </message>
    <message>
        <source>Strain range %</source>
        <translation>Dehnung von … bis %</translation>
    </message>
    <message>
        <source>Flips</source>
        <translation>Umgeklappt</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Kreuzungen</translation>
    </message>
    <message>
        <source>To reference rms %1</source>
        <translation>Zur Referenz, Mittel %1</translation>
    </message>
    <message>
        <source>To reference max %1</source>
        <translation>Zur Referenz, größter %1</translation>
    </message>
    <message>
        <source>Not flattened yet</source>
        <translation>Noch nicht abgewickelt</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paar</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Stoffart</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgenommen</translation>
    </message>
    <message>
        <source>Flat, hidden</source>
        <translation>Flach, ausgeblendet</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Flat, exceeds any fabric</source>
        <translation>Flach, zu viel für jeden Stoff</translation>
    </message>
    <message>
        <source>No fabric can take this strain. Cut the piece where it curves most.</source>
        <translation>Kein Stoff hält diese Dehnung aus. Schneiden Sie das Teil dort ein, wo es am stärksten gewölbt ist.</translation>
    </message>
    <message>
        <source>%1. Double-click or press F2 to rename it</source>
        <translation>%1. Doppelklick oder F2, um es umzubenennen</translation>
    </message>
    <message>
        <source>Number to cut. Double-click to change it for all selected pieces</source>
        <translation>Anzahl zum Zuschneiden. Doppelklick ändert sie bei allen ausgewählten Schnittteilen</translation>
    </message>
    <message>
        <source>A mirrored copy is also cut. Click or press Space to change this</source>
        <translation>Eine gespiegelte Kopie wird auch zugeschnitten. Klick oder Leertaste ändert es</translation>
    </message>
    <message>
        <source>No mirrored copy is cut. Click or press Space to cut left and right</source>
        <translation>Keine gespiegelte Kopie. Klick oder Leertaste, um links und rechts zuzuschneiden</translation>
    </message>
    <message>
        <source>%1 – out of date: shape or method has changed since</source>
        <translation>%1 – veraltet: Form oder Verfahren haben sich seitdem geändert</translation>
    </message>
    <message>
        <source>No piece of the reference pattern matches this one</source>
        <translation>Kein Teil des Referenzschnitts passt zu diesem</translation>
    </message>
    <message>
        <source>Several pieces of the reference pattern match: %1</source>
        <translation>Mehrere Teile des Referenzschnitts passen: %1</translation>
    </message>
    <message>
        <source>Compared with %1 of the reference pattern, mirrored</source>
        <translation>Verglichen mit %1 des Referenzschnitts, gespiegelt</translation>
    </message>
    <message>
        <source>Compared with %1 of the reference pattern</source>
        <translation>Verglichen mit %1 des Referenzschnitts</translation>
    </message>
    <message>
        <source>Whether the piece is flat, or why not</source>
        <translation>Ob das Schnittteil flach ist, oder warum nicht</translation>
    </message>
    <message>
        <source>Number of copies to cut</source>
        <translation>Wie oft das Schnittteil zugeschnitten wird</translation>
    </message>
    <message>
        <source>Also cut a mirrored copy of each: left and right</source>
        <translation>Jedes auch gespiegelt zuschneiden: links und rechts</translation>
    </message>
    <message>
        <source>Material of the piece; empty: garment&apos;s fabric</source>
        <translation>Stoffart des Schnittteils; leer: Stoff des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Layer of cloth that the piece belongs to; 1 is the outermost</source>
        <translation>Stofflage des Schnittteils; 1 ist die äußerste</translation>
    </message>
    <message>
        <source>Flattening method of the piece; grey if the result is out of date</source>
        <translation>Verfahren des Schnittteils; grau, wenn das Ergebnis veraltet ist</translation>
    </message>
    <message>
        <source>Number of triangles in the mesh</source>
        <translation>Anzahl der Dreiecke im Netz</translation>
    </message>
    <message>
        <source>Length of the seam line around the flat piece</source>
        <translation>Länge der Nahtlinie rund um das flache Schnittteil</translation>
    </message>
    <message>
        <source>Largest length difference of an outline edge between pattern and garment</source>
        <translation>Größter Längenunterschied einer Umrisskante zwischen Schnitt und Kleidungsstück</translation>
    </message>
    <message>
        <source>Mean size of stretch and surplus</source>
        <translation>Mittlere Größe von Dehnung und Überschuss</translation>
    </message>
    <message>
        <source>From the largest surplus to the largest stretch; + is stretch</source>
        <translation>Vom größten Überschuss zur größten Dehnung; + ist Dehnung</translation>
    </message>
    <message>
        <source>Triangles that are flipped in the pattern: must be 0</source>
        <translation>Dreiecke, die im Schnittmuster umgeklappt sind: muss 0 sein</translation>
    </message>
    <message>
        <source>Points where the outline crosses itself: must be 0</source>
        <translation>Stellen, an denen sich der Umriss selbst kreuzt: muss 0 sein</translation>
    </message>
    <message>
        <source>Root mean square distance from the best-fitting reference panel or pattern</source>
        <translation>Quadratisches Mittel des Abstands vom bestmöglich aufgelegten Referenzteil oder -schnitt</translation>
    </message>
    <message>
        <source>Largest distance from the reference panel or pattern</source>
        <translation>Größter Abstand vom Referenzteil oder Referenzschnitt</translation>
    </message>
    <message>
        <source>Compared with %1 of the reference pattern; uncertain, because the sizes differ</source>
        <translation>Verglichen mit %1 des Referenzschnitts; unsicher, weil die Größen abweichen</translation>
    </message>
</context>
<context>
    <name>toile::app::PiecesPanel</name>
    <message>
        <source>Not flattened yet.</source>
        <translation>Noch nicht abgewickelt.</translation>
    </message>
    <message>
        <source>Area, garment</source>
        <translation>Fläche, Kleidungsstück</translation>
    </message>
    <message>
        <source>Area, flat</source>
        <translation>Fläche, flach</translation>
    </message>
    <message>
        <source>Outline, garment</source>
        <translation>Umriss, Kleidungsstück</translation>
    </message>
    <message>
        <source>Outline, flat</source>
        <translation>Umriss, flach</translation>
    </message>
    <message>
        <source>Outline error</source>
        <translation>Umrissfehler</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Strain, mean</source>
        <translation>Dehnung, Mittel</translation>
    </message>
    <message>
        <source>Strain, range</source>
        <translation>Dehnung, von … bis</translation>
    </message>
    <message>
        <source>To reference, rms / max</source>
        <translation>Zur Referenz, Mittel / größter</translation>
    </message>
    <message>
        <source>Uneven stretch (1 = even)</source>
        <translation>Ungleiche Dehnung (1 = gleich)</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The whole garment</source>
        <translation>Das ganze Kleidungsstück</translation>
    </message>
    <message>
        <source>Selected pieces</source>
        <translation>Ausgewählte Schnittteile</translation>
    </message>
    <message>
        <source>Pieces, flat</source>
        <translation>Schnittteile, flach</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Pieces to cut</source>
        <translation>Zu schneiden</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>Changed by</source>
        <translation>Geändert durch</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Select a piece in a view or in the table to see its figures.</source>
        <translation>Wählen Sie ein Schnittteil in einer Ansicht oder in der Liste, um seine Werte zu sehen.</translation>
    </message>
    <message>
        <source>Minimum cloth needed</source>
        <translation>Stoffbedarf mindestens</translation>
    </message>
</context>
<context>
    <name>toile::app::PlayBar</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
</context>
<context>
    <name>toile::app::PositionForm</name>
    <message>
        <source>Left edge</source>
        <translation>Linke Kante</translation>
    </message>
    <message>
        <source>Lower edge</source>
        <translation>Untere Kante</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Wrong side up</source>
        <translation>Linke Stoffseite oben</translation>
    </message>
    <message>
        <source>Mirrored: the wrong side of the fabric faces you</source>
        <translation>Gespiegelt: Die linke Stoffseite liegt oben</translation>
    </message>
    <message>
        <source>&amp;Left edge</source>
        <translation>&amp;Linke Kante</translation>
    </message>
    <message>
        <source>Lo&amp;wer edge</source>
        <translation>&amp;Untere Kante</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 spiegeln</translation>
    </message>
    <message>
        <source>Distance from the origin to the left edge of the selection</source>
        <translation>Abstand vom Nullpunkt zur linken Kante der Auswahl</translation>
    </message>
    <message>
        <source>Distance from the origin up to the lower edge of the selection</source>
        <translation>Abstand vom Nullpunkt hinauf zur unteren Kante der Auswahl</translation>
    </message>
    <message>
        <source>Anti-clockwise rotation of the piece about its centre</source>
        <translation>Drehung des Schnittteils um seine Mitte, gegen den Uhrzeigersinn</translation>
    </message>
</context>
<context>
    <name>toile::app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Units and language</source>
        <translation>Einheiten und Sprache</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Inches, decimals</source>
        <translation>Zoll, dezimal</translation>
    </message>
    <message>
        <source>Inches, eighths</source>
        <translation>Zoll, Achtel</translation>
    </message>
    <message>
        <source>Inches, sixteenths</source>
        <translation>Zoll, Sechzehntel</translation>
    </message>
    <message>
        <source>Inches, thirty-seconds</source>
        <translation>Zoll, Zweiunddreißigstel</translation>
    </message>
    <message>
        <source>&amp;Lengths:</source>
        <translation>&amp;Längen:</translation>
    </message>
    <message>
        <source>L&amp;anguage:</source>
        <translation>&amp;Sprache:</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Farbschema:</translation>
    </message>
    <message>
        <source>&amp;Selected pieces:</source>
        <translation>&amp;Ausgewählte Schnittteile:</translation>
    </message>
    <message>
        <source>Selected s&amp;eam:</source>
        <translation>Ausgewählte &amp;Naht:</translation>
    </message>
    <message>
        <source>Toile</source>
        <translation>Toile</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>CLO</source>
        <translation>CLO</translation>
    </message>
    <message>
        <source>Rhino</source>
        <translation>Rhino</translation>
    </message>
    <message>
        <source>&amp;Mouse as in:</source>
        <translation>&amp;Maus wie in:</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> Dreiecke</translation>
    </message>
    <message>
        <source>&amp;Flatten after edits up to:</source>
        <translation>Nach Änderungen ab&amp;wickeln bis:</translation>
    </message>
    <message>
        <source>Exact outlines</source>
        <translation>Genauen Umrissen</translation>
    </message>
    <message>
        <source>A pattern to cut and sew</source>
        <translation>Einem Schnittmuster zum Zuschneiden und Nähen</translation>
    </message>
    <message>
        <source>&amp;New garments start with:</source>
        <translation>&amp;Neue Kleidungsstücke beginnen mit:</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>What pattern makers need</source>
        <translation>Was man zum Schnittmachen braucht</translation>
    </message>
    <message>
        <source>M&amp;enus show:</source>
        <translation>M&amp;enüs zeigen:</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Reset to the defaults; Cancel undoes this</source>
        <translation>Auf die Vorgaben zurücksetzen; Abbrechen nimmt es zurück</translation>
    </message>
    <message>
        <source>Unit for lengths; you can enter other units too</source>
        <translation>Einheit für Längen; eingeben können Sie auch andere</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Restart Toile to change the language.</source>
        <translation>Starten Sie Toile neu, um die Sprache zu wechseln.</translation>
    </message>
    <message>
        <source>Mouse controls like those of this program</source>
        <translation>Maussteuerung wie in diesem Programm</translation>
    </message>
    <message>
        <source>Patterns to cut and sew have fair lines, trued seam ends, equal mirrored pieces, allowances and notches. Open garments do not change</source>
        <translation>Schnittmuster zum Nähen haben ausgeglichene Linien und Nahtenden, gleiche gespiegelte Schnittteile, Zugaben und Knipse. Offene Kleidungsstücke ändern sich nicht</translation>
    </message>
    <message>
        <source>Hide research methods, their overlays and mesh commands. Those in use stay visible</source>
        <translation>Forschungsverfahren, ihre Überlagerungen und Netzbefehle ausblenden. Verwendete bleiben sichtbar</translation>
    </message>
    <message>
        <source>How often Toile saves a backup against crashes</source>
        <translation>Wie oft Toile eine Sicherung gegen Abstürze speichert</translation>
    </message>
    <message>
        <source>&amp;Back up every:</source>
        <translation>&amp;Sicherung alle:</translation>
    </message>
    <message>
        <source>Larger garments are flattened only on request</source>
        <translation>Größere Kleidungsstücke werden nur auf Verlangen abgewickelt</translation>
    </message>
</context>
<context>
    <name>toile::app::PrintDialog</name>
    <message>
        <source>Print pattern</source>
        <translation>Schnitt drucken</translation>
    </message>
    <message>
        <source>&amp;Export as PDF…</source>
        <translation>Als PDF &amp;exportieren…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>P&amp;age:</source>
        <translation>&amp;Seite:</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>%1 of %2 x %3 mm, at true scale</source>
        <translation>%1 zu %2 x %3 mm, maßstabsgetreu</translation>
    </message>
    <message>
        <source>1 page</source>
        <translation>1 Seite</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n Seiten</numerusform>
            <numerusform>%n Seiten</numerusform>
        </translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>Drawing the pattern…</source>
        <translation>Schnitt wird gezeichnet…</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Export the pattern as PDF and print it elsewhere.</source>
        <translation>Auf diesem Computer ist kein Drucker eingerichtet. Exportieren Sie den Schnitt als PDF und drucken Sie ihn anderswo.</translation>
    </message>
    <message>
        <source>A projector needs a file. Export the page as PDF.</source>
        <translation>Ein Projektor braucht eine Datei. Exportieren Sie die Seite als PDF.</translation>
    </message>
</context>
<context>
    <name>toile::app::ProblemsModel</name>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Worst: %1</source>
        <translation>Am schlimmsten: %1</translation>
    </message>
    <message>
        <source>Whole garment</source>
        <translation>Ganzes Kleidungsstück</translation>
    </message>
    <message>
        <source>Prepare the scan first: Garment &gt; Treat file as &gt; Scan</source>
        <translation>Bereiten Sie zuerst den Scan auf: Kleidungsstück &gt; Datei lesen als &gt; Scan</translation>
    </message>
    <message>
        <source>Cut it along a seam, or use Piece &gt; Cut open</source>
        <translation>Schneiden Sie es entlang einer Naht auf, oder verwenden Sie Schnittteil &gt; Aufschneiden</translation>
    </message>
    <message>
        <source>Remedy</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Rat</translation>
    </message>
</context>
<context>
    <name>toile::app::ProblemsPanel</name>
    <message>
        <source>Ready to cut?</source>
        <translation>Bereit zum Zuschneiden?</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>List the errors to fix before cutting</source>
        <translation>Die Fehler auflisten, die vor dem Zuschneiden zu beheben sind</translation>
    </message>
    <message>
        <source>List the warnings to look at before cutting</source>
        <translation>Die Warnungen auflisten, die vor dem Zuschneiden anzusehen sind</translation>
    </message>
    <message>
        <source>List the notes</source>
        <translation>Die Hinweise auflisten</translation>
    </message>
    <message>
        <source>Go to place</source>
        <translation>Zur Stelle gehen</translation>
    </message>
    <message>
        <source>Ready to cut: seams match, no outline crosses itself, the strain is within the fabric&apos;s limits, and every grain is set.</source>
        <translation>Bereit zum Zuschneiden: Nähte passen, kein Umriss kreuzt sich, die Dehnung liegt in den Grenzen des Stoffs, und jeder Fadenlauf ist gesetzt.</translation>
    </message>
    <message>
        <source>All findings are hidden. Use the buttons above to show them.</source>
        <translation>Alle Befunde sind ausgeblendet. Die Knöpfe darüber zeigen sie.</translation>
    </message>
</context>
<context>
    <name>toile::app::ProjectSession</name>
    <message numerus="yes">
        <source>And %n more like this.</source>
        <translation>
            <numerusform>Und %n weitere dieser Art.</numerusform>
            <numerusform>Und %n weitere dieser Art.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>toile::app::ProofForm</name>
    <message>
        <source>Fabric</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>The design</source>
        <translation>Der Entwurf</translation>
    </message>
    <message>
        <source>A body…</source>
        <translation>Ein Körper…</translation>
    </message>
    <message>
        <source>Another body…</source>
        <translation>Ein anderer Körper…</translation>
    </message>
    <message>
        <source>Measured cloth</source>
        <translation>Gemessener Stoff</translation>
    </message>
    <message>
        <source>Unit of the body</source>
        <translation>Einheit des Körpers</translation>
    </message>
    <message>
        <source>1 = %1 mm</source>
        <translation>1 = %1 mm</translation>
    </message>
    <message>
        <source>Dress form</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Use measured values of the cloth instead of its fabric&apos;s values</source>
        <translation>Gemessene Werte des Stoffs anstelle der Werte seiner Art verwenden</translation>
    </message>
    <message>
        <source>Surface under the cloth during sewing: the design itself, or the mesh of a body.</source>
        <translation>Die Fläche unter dem Stoff beim Nähen: der Entwurf selbst oder das Netz eines Körpers.</translation>
    </message>
    <message>
        <source>Unit of the body&apos;s file.</source>
        <translation>Die Einheit der Datei des Körpers.</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1, gemessen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Change unit of the body</source>
        <translation>Einheit des Körpers ändern</translation>
    </message>
    <message>
        <source>Use design as dress form</source>
        <translation>Auf dem Entwurf nähen</translation>
    </message>
</context>
<context>
    <name>toile::app::ProofModel</name>
    <message>
        <source>Piece</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Gap (%1)</source>
        <translation>Abstand (%1)</translation>
    </message>
    <message>
        <source>95 % (%1)</source>
        <translation>95 % (%1)</translation>
    </message>
    <message>
        <source>Largest (%1)</source>
        <translation>Größter (%1)</translation>
    </message>
    <message>
        <source>Pulls (%)</source>
        <translation>Spannt (%)</translation>
    </message>
    <message>
        <source>Slack (%)</source>
        <translation>Lose (%)</translation>
    </message>
    <message>
        <source>Hangs free (%)</source>
        <translation>Hängt frei (%)</translation>
    </message>
    <message>
        <source>Piece of the garment; click to go to its largest gap</source>
        <translation>Schnittteil des Kleidungsstücks; ein Klick führt zu seinem größten Abstand</translation>
    </message>
    <message>
        <source>Mean distance from the design</source>
        <translation>Mittlerer Abstand vom Entwurf</translation>
    </message>
    <message>
        <source>Gap that 95 % of its area does not exceed</source>
        <translation>Abstand, den 95 % seiner Fläche nicht überschreiten</translation>
    </message>
    <message>
        <source>Largest gap</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>Stretch that 95 % of its area does not exceed</source>
        <translation>Dehnung, die 95 % seiner Fläche nicht überschreiten</translation>
    </message>
    <message>
        <source>Surplus that 95 % of its area does not exceed</source>
        <translation>Überschuss, den 95 % seiner Fläche nicht überschreiten</translation>
    </message>
    <message>
        <source>Share of its area that touches nothing</source>
        <translation>Anteil seiner Fläche, der nichts berührt</translation>
    </message>
</context>
<context>
    <name>toile::app::ProofPanel</name>
    <message>
        <source>Proof</source>
        <translation>Nähprobe</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>Sewn pieces</source>
        <translation>Genähte Schnittteile</translation>
    </message>
    <message>
        <source>Gap %1 on average, 95 % %2, at most %3 %4</source>
        <translation>Abstand im Mittel %1, 95 % %2, höchstens %3 %4</translation>
    </message>
    <message>
        <source>%1 % hangs free</source>
        <translation>%1 % hängen frei</translation>
    </message>
    <message>
        <source>settled after %1 steps, %2 s</source>
        <translation>nach %1 Schritten zur Ruhe gekommen, %2 s</translation>
    </message>
    <message>
        <source>seam %1</source>
        <translation>Naht %1</translation>
    </message>
    <message>
        <source>Does not fit (%1)</source>
        <translation>Passt nicht (%1)</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Every seam and piece fits</source>
        <translation>Alle Nähte und Schnittteile passen</translation>
    </message>
    <message>
        <source>Prove again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>Prove by sewing</source>
        <translation>Durch Nähen prüfen</translation>
    </message>
    <message>
        <source>%1 triangles with edges of %2</source>
        <translation>%1 Dreiecke mit Kanten von %2</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>Misfits</source>
        <translation>Was nicht passt</translation>
    </message>
    <message>
        <source>not settled after %1 steps: figures are approximate</source>
        <translation>nach %1 Schritten nicht zur Ruhe gekommen: die Werte sind ungefähr</translation>
    </message>
    <message>
        <source>Sides differ by %1</source>
        <translation>Seiten unterscheiden sich um %1</translation>
    </message>
    <message>
        <source>Pattern has changed</source>
        <translation>Schnitt geändert</translation>
    </message>
    <message>
        <source>Settings have changed</source>
        <translation>Einstellungen geändert</translation>
    </message>
    <message>
        <source>The pattern, fabric or seams have changed since this proof. Prove again</source>
        <translation>Schnitt, Stoff oder Nähte haben sich seit dieser Nähprobe geändert. Prüfen Sie erneut</translation>
    </message>
    <message>
        <source>The settings have changed since this proof. Prove again</source>
        <translation>Die Einstellungen haben sich seit dieser Nähprobe geändert. Prüfen Sie erneut</translation>
    </message>
    <message>
        <source>Sewing the pattern. The garment view shows the progress.</source>
        <translation>Der Schnitt wird genäht. Die Ansicht des Kleidungsstücks zeigt den Fortschritt.</translation>
    </message>
    <message>
        <source>Sew the exported pattern together over the design, and measure the difference: gaps, pulling cloth and seams that do not fit.</source>
        <translation>Den exportierten Schnitt über dem Entwurf zusammennähen und die Abweichung messen: Abstände, gespannter Stoff und Nähte, die nicht passen.</translation>
    </message>
    <message>
        <source>No flat pieces to sew yet.</source>
        <translation>Noch keine flachen Schnittteile zum Nähen.</translation>
    </message>
</context>
<context>
    <name>toile::app::ProposalsForm</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Swap front and back</source>
        <translation>&amp;Vorn und hinten tauschen</translation>
    </message>
    <message>
        <source>Proposed cuts</source>
        <translation>Vorgeschlagene Schnitte</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Dart</source>
        <translation>Abnäher</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Looking for cuts in %1…</source>
        <translation>Schnitte in %1 werden gesucht …</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>fabric: %1</source>
        <translation>Material: %1</translation>
    </message>
    <message>
        <source>Stop at strai&amp;n</source>
        <translation>Ende bei Deh&amp;nung</translation>
    </message>
    <message>
        <source>Stop at strain</source>
        <translation>Ende bei Dehnung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>&amp;Apply cuts</source>
        <translation>Schnitte &amp;anwenden</translation>
    </message>
    <message>
        <source>Strain after</source>
        <translation>Dehnung danach</translation>
    </message>
    <message>
        <source>Mean strain after this cut and those above: predicted, or bold if flattened</source>
        <translation>Mittlere Dehnung nach diesem und den Schnitten darüber: vorhergesagt, fett wenn abgewickelt</translation>
    </message>
    <message>
        <source>Intake of the dart at the edge</source>
        <translation>Inhalt des Abnähers am Rand</translation>
    </message>
    <message>
        <source>Apply this &amp;cut</source>
        <translation>Diesen &amp;Schnitt anwenden</translation>
    </message>
    <message>
        <source>Mean strain in per cent below which no more cuts are proposed. Empty: the fabric&apos;s limit</source>
        <translation>Mittlere Dehnung in Prozent, unter der keine Schnitte mehr vorgeschlagen werden. Leer: die Grenze des Stoffs</translation>
    </message>
    <message>
        <source>Swap the guessed front and back if names and cuts are on the wrong side</source>
        <translation>Vermutetes Vorn und Hinten tauschen, wenn Namen und Schnitte auf der falschen Seite liegen</translation>
    </message>
    <message>
        <source>Apply the selected cuts as one undo step</source>
        <translation>Die ausgewählten Schnitte als einen Schritt anwenden</translation>
    </message>
    <message>
        <source>No cuts to propose for %1: it needs none, or Toile does not recognise its shape. Use Piece ▸ Cut open or the cutting tools.</source>
        <translation>Keine Schnitte für %1: Es braucht keine, oder Toile erkennt die Form nicht. Verwenden Sie Schnittteil ▸ Aufschneiden oder die Schnittwerkzeuge.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 cuts selected, %4 long.</source>
        <translation>%1: %2 von %3 Schnitten ausgewählt, %4 lang.</translation>
    </message>
    <message>
        <source>Flattening the best cuts…</source>
        <translation>Die besten Schnitte werden abgewickelt…</translation>
    </message>
    <message>
        <source>Predicted before you moved cuts: %1</source>
        <translation>Vorhergesagt, bevor Sie Schnitte verschoben haben: %1</translation>
    </message>
    <message>
        <source>Predicted: mean %1, maximum %2</source>
        <translation>Vorhergesagt: im Mittel %1, höchstens %2</translation>
    </message>
    <message>
        <source>Flattened: mean %1, maximum %2</source>
        <translation>Abgewickelt: im Mittel %1, höchstens %2</translation>
    </message>
</context>
<context>
    <name>toile::app::RecentFiles</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>This file no longer exists</source>
        <translation>Diese Datei gibt es nicht mehr</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Keine zuletzt geöffneten Dateien</translation>
    </message>
    <message>
        <source>Clear the list of recent files</source>
        <translation>Die Liste der zuletzt geöffneten Dateien leeren</translation>
    </message>
</context>
<context>
    <name>toile::app::Recovery</name>
    <message>
        <source>Toile closed before you saved your changes to %1. The last backup is from %2 at %3.</source>
        <translation>Toile wurde beendet, bevor Ihre Änderungen an %1 gespeichert waren. Die letzte Sicherung ist vom %2 um %3.</translation>
    </message>
</context>
<context>
    <name>toile::app::RecoveryCard</name>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Open the garment from the last backup</source>
        <translation>Das Kleidungsstück aus der letzten Sicherung öffnen</translation>
    </message>
    <message>
        <source>Delete the backup permanently</source>
        <translation>Die Sicherung endgültig löschen</translation>
    </message>
</context>
<context>
    <name>toile::app::ReferenceFinder</name>
    <message>
        <source>Reference pattern %1: %2 of %3 pieces matched</source>
        <translation>Referenzschnitt %1: %2 von %3 Schnittteilen zugeordnet</translation>
    </message>
    <message>
        <source>no match: %1</source>
        <translation>ohne Gegenstück: %1</translation>
    </message>
    <message>
        <source>several matches: %1</source>
        <translation>passt zu mehreren: %1</translation>
    </message>
    <message>
        <source>only in the file: %1</source>
        <translation>nur in der Datei: %1</translation>
    </message>
    <message>
        <source>unit uncertain, read as %1</source>
        <translation>Einheit unsicher, gelesen als %1</translation>
    </message>
    <message>
        <source>uncertain, because the sizes differ: %1</source>
        <translation>unsicher, weil die Größen abweichen: %1</translation>
    </message>
</context>
<context>
    <name>toile::app::ScanForm</name>
    <message>
        <source>Prepare the scan</source>
        <translation>Scan aufbereiten</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
</context>
<context>
    <name>toile::app::SeamEndsList</name>
    <message>
        <source>Seam ends</source>
        <translation>Nahtenden</translation>
    </message>
    <message>
        <source>Seam end</source>
        <translation>Nahtende</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Am</translation>
    </message>
    <message>
        <source>Kink</source>
        <translation>Knick</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Select to remove the kink at this seam end</source>
        <translation>Auswählen, um den Knick an diesem Nahtende zu entfernen</translation>
    </message>
    <message>
        <source>Start or end of the seam</source>
        <translation>Anfang oder Ende der Naht</translation>
    </message>
    <message>
        <source>Kink between the two lines at the seam end, as flattened</source>
        <translation>Knick zwischen den beiden Linien am Nahtende, nach dem Abwickeln</translation>
    </message>
    <message>
        <source>Remaining kink in the drawn pattern</source>
        <translation>Verbleibender Knick im gezeichneten Schnitt</translation>
    </message>
</context>
<context>
    <name>toile::app::SeamsModel</name>
    <message>
        <source>seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>dart</source>
        <translation>Abnäher</translation>
    </message>
    <message>
        <source>pleat</source>
        <translation>Falte</translation>
    </message>
    <message>
        <source>free edge</source>
        <translation>freie Kante</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the seam in the garment</source>
        <translation>Nummer der Naht im Kleidungsstück</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>The pieces sewn together; the left one is named first</source>
        <translation>Die zusammengenähten Schnittteile; das linke zuerst</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>3D %1</source>
        <translation>3D %1</translation>
    </message>
    <message>
        <source>Flat left %1</source>
        <translation>Flach links %1</translation>
    </message>
    <message>
        <source>Length of the left piece&apos;s edge in the pattern</source>
        <translation>Länge der Kante des linken Schnittteils im Schnittmuster</translation>
    </message>
    <message>
        <source>Flat right %1</source>
        <translation>Flach rechts %1</translation>
    </message>
    <message>
        <source>Length of the right piece&apos;s edge in the pattern</source>
        <translation>Länge der Kante des rechten Schnittteils im Schnittmuster</translation>
    </message>
    <message>
        <source>Difference %1</source>
        <translation>Unterschied %1</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>Einhalteweite %</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Passung</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>Changed by %1</source>
        <translation>Geändert durch, %1</translation>
    </message>
    <message>
        <source>%1: a third layer in this seam</source>
        <translation>%1: eine dritte Lage in dieser Naht</translation>
    </message>
    <message>
        <source>Set by you. Press Delete to reset it to the 3D lengths.</source>
        <translation>Von Ihnen gesetzt. Entf setzt sie auf die 3D-Längen zurück.</translation>
    </message>
    <message>
        <source>From the 3D lengths. Double-click or press F2 to set your own ease.</source>
        <translation>Aus den 3D-Längen. Doppelklick oder F2, um eine eigene Einhalteweite zu setzen.</translation>
    </message>
    <message>
        <source>Seam, dart, pleat or free edge</source>
        <translation>Naht, Abnäher, Falte oder freie Kante</translation>
    </message>
    <message>
        <source>Length on the garment; left / right if they differ</source>
        <translation>Länge am Kleidungsstück; links / rechts, wenn sie sich unterscheiden</translation>
    </message>
    <message>
        <source>Flat left minus flat right: the length to ease in when sewing</source>
        <translation>Flach links minus flach rechts: die Länge, die beim Nähen einzuhalten ist</translation>
    </message>
    <message>
        <source>How much longer the left edge is. Grey: from the garment; bold: set by you. Double-click or F2: set, Delete: reset</source>
        <translation>Wie viel länger die linke Kante ist. Grau: vom Kleidungsstück; fett: von Ihnen gesetzt. Doppelklick oder F2: setzen, Entf: zurücksetzen</translation>
    </message>
    <message>
        <source>Whether the pattern draws the longer edge with your ease</source>
        <translation>Ob der Schnitt die längere Kante mit Ihrer Einhalteweite zeichnet</translation>
    </message>
    <message>
        <source>Why and by how much the seam length differs from the garment</source>
        <translation>Warum und um wie viel die Nahtlänge vom Kleidungsstück abweicht</translation>
    </message>
    <message>
        <source>Difference that remains after subtracting the ease</source>
        <translation>Unterschied, der nach Abzug der Einhalteweite bleibt</translation>
    </message>
    <message>
        <source>Matches: up to %1; nearly: up to %2; does not match: above</source>
        <translation>Passt: bis %1; fast: bis %2; passt nicht: darüber</translation>
    </message>
</context>
<context>
    <name>toile::app::SeamsPanel</name>
    <message>
        <source>Show free edges</source>
        <translation>Freie Kanten zeigen</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>No seams</source>
        <translation>Keine Nähte</translation>
    </message>
    <message>
        <source>Also list hems, openings and other edges that are not sewn</source>
        <translation>Auch Säume, Öffnungen und andere nicht genähte Kanten auflisten</translation>
    </message>
    <message>
        <source>No edges of this garment meet, so nothing is sewn. Use “Show free edges” to list the edges.</source>
        <translation>Keine Kanten dieses Kleidungsstücks treffen sich, also ist nichts genäht. „Freie Kanten zeigen“ listet die Kanten auf.</translation>
    </message>
</context>
<context>
    <name>toile::app::SegmentForm</name>
    <message>
        <source>%1: free edge</source>
        <translation>%1: freie Kante</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Add turn point</source>
        <translation>Eckpunkt setzen</translation>
    </message>
    <message>
        <source>Remove turn point</source>
        <translation>Eckpunkt entfernen</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>kink %1</source>
        <translation>Knick %1</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>Ends: %1, %2</source>
        <translation>Enden: %1, %2</translation>
    </message>
    <message>
        <source>Remove the notch nearest to the middle</source>
        <translation>Den Knips entfernen, der der Mitte am nächsten ist</translation>
    </message>
    <message>
        <source>On both sides</source>
        <translation>Auf beiden Seiten</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Knipse</translation>
    </message>
    <message>
        <source>Select a seam, or double-click a part of an outline.</source>
        <translation>Wählen Sie eine Naht, oder doppelklicken Sie auf ein Stück Umriss.</translation>
    </message>
    <message>
        <source>%1, facing</source>
        <translation>%1, Beleg</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Knips</translation>
    </message>
    <message>
        <source>Let the outline turn at the selected vertex, and end the segment there</source>
        <translation>Den Umriss an der ausgewählten Netzecke abbiegen lassen und den Abschnitt dort beenden</translation>
    </message>
    <message>
        <source>Let the outline continue smoothly at the selected vertex</source>
        <translation>Den Umriss an der ausgewählten Netzecke glatt weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Add a notch in the middle of the longest part without notches</source>
        <translation>Einen Knips in der Mitte der längsten Strecke ohne Knips setzen</translation>
    </message>
    <message>
        <source>Also set the allowance of the edge that is sewn to this one</source>
        <translation>Auch die Zugabe der Kante setzen, die an diese genäht wird</translation>
    </message>
    <message>
        <source>Kink: angle between the joined lines of a sewn seam end. Turn: angle of the outline at other ends</source>
        <translation>Knick: Winkel zwischen den Linien an einem genähten Nahtende. Ecke: Winkel des Umrisses an anderen Enden</translation>
    </message>
    <message>
        <source>Add notch</source>
        <translation>Knips setzen</translation>
    </message>
    <message>
        <source>Remove notch</source>
        <translation>Knips entfernen</translation>
    </message>
    <message>
        <source>The previous segment is %1.</source>
        <translation>Der vorige Abschnitt ist %1.</translation>
    </message>
    <message>
        <source>Delete notch</source>
        <translation>Knips löschen</translation>
    </message>
    <message>
        <source>found: %1</source>
        <translation>erkannt: %1</translation>
    </message>
    <message>
        <source>%1 in 3D, %2 in the pattern.</source>
        <translation>%1 in 3D, %2 im Schnittmuster.</translation>
    </message>
    <message>
        <source>%1 in 3D.</source>
        <translation>%1 in 3D.</translation>
    </message>
    <message>
        <source>the piece is narrow</source>
        <translation>das Teil schmal ist</translation>
    </message>
    <message>
        <source>the edge is curved</source>
        <translation>die Kante gebogen ist</translation>
    </message>
    <message>
        <source>the piece is small</source>
        <translation>das Teil klein ist</translation>
    </message>
    <message>
        <source>Allowance %1 instead of %2, because %3.</source>
        <translation>Zugabe %1 statt %2, weil %3.</translation>
    </message>
</context>
<context>
    <name>toile::app::SelectTool</name>
    <message>
        <source>Nudge %1</source>
        <translation>%1 rücken</translation>
    </message>
    <message>
        <source>Click a dashed line: select the proposed cut · Drag a handle: move it · Esc: close the proposals</source>
        <translation>Klick auf eine gestrichelte Linie: den vorgeschlagenen Schnitt auswählen · Griff ziehen: ihn verschieben · Esc: die Vorschläge schließen</translation>
    </message>
    <message>
        <source>Click: select a piece or a seam · Double click: frame a piece, or select an edge from corner to corner · Esc: clear the selection</source>
        <translation>Klick: Schnittteil oder Naht auswählen · Doppelklick: Schnittteil einpassen oder eine Kante von Ecke zu Ecke auswählen · Esc: Auswahl aufheben</translation>
    </message>
    <message>
        <source>Click: select a piece or a seam · Drag a piece: move it · Drag the sheet: select with a box · Alt: toggle snapping · Arrow keys: %1, with Shift %2 · Esc: clear the selection</source>
        <translation>Klick: Schnittteil oder Naht auswählen · Schnittteil ziehen: verschieben · Bogen ziehen: mit einem Rahmen auswählen · Alt: Einrasten umkehren · Pfeiltasten: %1, mit Umschalt %2 · Esc: Auswahl aufheben</translation>
    </message>
</context>
<context>
    <name>toile::app::SelectionPanel</name>
    <message>
        <source>Select a piece, a seam or an edge to change its properties.</source>
        <translation>Wählen Sie ein Schnittteil, eine Naht oder eine Kante, um die Eigenschaften zu ändern.</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
</context>
<context>
    <name>toile::app::SettingFields</name>
    <message>
        <source>Clear the field to remove your value.</source>
        <translation>Leeren Sie das Feld, um Ihren Wert zu entfernen.</translation>
    </message>
    <message>
        <source>Bold: set by you.</source>
        <translation>Fett: von Ihnen gesetzt.</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1: aus</translation>
    </message>
    <message>
        <source>Remove your value</source>
        <translation>Ihren Wert entfernen</translation>
    </message>
</context>
<context>
    <name>toile::app::SewnBar</name>
    <message>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Sewn</source>
        <translation>Genäht</translation>
    </message>
    <message>
        <source>From design to sewn pattern</source>
        <translation>Vom Entwurf zum genähten Schnitt</translation>
    </message>
    <message>
        <source>Go from the design (left) to the sewn pattern (right)</source>
        <translation>Vom Entwurf (links) zum genähten Schnitt (rechts)</translation>
    </message>
    <message>
        <source>Play from design to sewn pattern and back</source>
        <translation>Vom Entwurf zum genähten Schnitt und zurück abspielen</translation>
    </message>
</context>
<context>
    <name>toile::app::SheetPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
</context>
<context>
    <name>toile::app::StatedEdit</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>toile::app::SymmetryPanel</name>
    <message>
        <source>Mirror &amp;edits</source>
        <translation>Änderungen s&amp;piegeln</translation>
    </message>
    <message>
        <source>equal: the mean of both</source>
        <translation>gleich: das Mittel beider</translation>
    </message>
    <message>
        <source>equal: one for both</source>
        <translation>gleich: eines für beide</translation>
    </message>
    <message>
        <source>&amp;Mirrored pieces</source>
        <translation>&amp;Gespiegelte Schnittteile</translation>
    </message>
    <message>
        <source>Mirrored pieces</source>
        <translation>Gespiegelte Schnittteile</translation>
    </message>
    <message>
        <source>Left and right differ by %1, at most %2.</source>
        <translation>Links und rechts weichen um %1 voneinander ab, höchstens um %2.</translation>
    </message>
    <message>
        <source>No mirror plane: left and right of this garment differ too much.</source>
        <translation>Keine Spiegelebene: links und rechts sind an diesem Kleidungsstück zu verschieden.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>equal if within 2 mm or 1 %</source>
        <translation>gleich, wenn innerhalb von 2 mm oder 1 %</translation>
    </message>
    <message>
        <source>How to draw mirrored pieces. Equal pieces get common lengths in mirrored seams</source>
        <translation>Wie gespiegelte Schnittteile gezeichnet werden. Gleiche Schnittteile erhalten in gespiegelten Nähten gemeinsame Längen</translation>
    </message>
    <message>
        <source>Apply cuts and grain changes to both mirrored pieces if they are drawn equal</source>
        <translation>Einschnitte und Fadenlauf auf beide gespiegelten Schnittteile anwenden, wenn sie gleich gezeichnet sind</translation>
    </message>
    <message>
        <source>Seams with no match on the other side</source>
        <translation>Nähte ohne Gegenstück</translation>
    </message>
    <message>
        <source>Seams and free edges without a mirror image keep their length</source>
        <translation>Nähte und freie Kanten ohne Spiegelbild behalten ihre Länge</translation>
    </message>
    <message>
        <source>Left and right are not compared. Choose how to draw mirrored pieces.</source>
        <translation>Links und rechts werden nicht verglichen. Wählen Sie, wie gespiegelte Schnittteile gezeichnet werden.</translation>
    </message>
    <message>
        <source>Flatten the pieces to find the mirror plane.</source>
        <translation>Wickeln Sie die Schnittteile ab, um die Spiegelebene zu finden.</translation>
    </message>
    <message>
        <source>%1 of %2 are drawn equal. Seams change by at most %3. The largest strain changes from %4 to %5.</source>
        <translation>%1 von %2 sind gleich gezeichnet. Nähte ändern sich um höchstens %3. Die größte Dehnung ändert sich von %4 auf %5.</translation>
    </message>
    <message>
        <source>No match on the other side (%1)</source>
        <translation>Ohne Gegenstück (%1)</translation>
    </message>
    <message>
        <source>Keep mirrored pieces as in the file</source>
        <translation>Gespiegelte Schnittteile wie in der Datei lassen</translation>
    </message>
    <message>
        <source>Make mirrored pieces equal</source>
        <translation>Gespiegelte Schnittteile angleichen</translation>
    </message>
</context>
<context>
    <name>toile::app::WalkBar</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>End the walk (Esc)</source>
        <translation>Das Ablaufen der Naht beenden (Esc)</translation>
    </message>
    <message>
        <source>%1 on itself</source>
        <translation>%1 an sich selbst</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 an %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>difference %1 %2 (ease %3)</source>
        <translation>Unterschied %1 %2 (Einhalteweite %3)</translation>
    </message>
    <message>
        <source>before notch 1 of %1</source>
        <translation>vor Knips 1 von %1</translation>
    </message>
    <message>
        <source>at notch %1 of %2</source>
        <translation>an Knips %1 von %2</translation>
    </message>
    <message>
        <source>past notch %1 of %2</source>
        <translation>nach Knips %1 von %2</translation>
    </message>
    <message>
        <source>Position along the seam</source>
        <translation>Position auf der Naht</translation>
    </message>
    <message>
        <source>Roll one piece along the seam of the other</source>
        <translation>Ein Schnittteil an der Naht des anderen abrollen</translation>
    </message>
    <message>
        <source>Play the walk forwards and back</source>
        <translation>Den Gang vor und zurück abspielen</translation>
    </message>
</context>
<context>
    <name>toile::app::WelcomePage</name>
    <message>
        <source>Open a garment…</source>
        <translation>Kleidungsstück öffnen…</translation>
    </message>
    <message>
        <source>From a 3D garment to a sewing pattern</source>
        <translation>Vom 3D-Kleidungsstück zum Schnittmuster</translation>
    </message>
    <message>
        <source>CLO, Marvelous Designer</source>
        <translation>CLO, Marvelous Designer</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Toile flattens every piece of a garment, keeps the length of its seam lines, and shows the strain of the cloth.</source>
        <translation>Toile wickelt jedes Teil eines Kleidungsstücks ab, behält die Länge seiner Nahtlinien und zeigt die Dehnung des Stoffs.</translation>
    </message>
    <message>
        <source>or drop OBJ, .zip, glTF, FBX, USD, PLY, STL or .toile files here; several meshes form one garment</source>
        <translation>oder OBJ-, .zip-, glTF-, FBX-, USD-, PLY-, STL- oder .toile-Dateien hier ablegen; mehrere Netze bilden ein Kleidungsstück</translation>
    </message>
    <message>
        <source>Or start with a sample</source>
        <translation>Oder mit einem Beispiel beginnen</translation>
    </message>
    <message>
        <source>Export as OBJ: all patterns, thin, in mm or cm, with the UV map. Toile gets the panels from the map.</source>
        <translation>Als OBJ exportieren: alle Schnittteile, dünn (thin), in mm oder cm, mit UV-Karte. Toile liest die Schnittteile aus der Karte.</translation>
    </message>
    <message>
        <source>Select the garment and export it as Wavefront OBJ, with modifiers applied and UV coordinates. If you marked seams and unwrapped, split by UV islands.</source>
        <translation>Das Kleidungsstück auswählen und als Wavefront OBJ exportieren, mit angewendeten Modifikatoren und UV-Koordinaten. Wenn Sie Nähte markiert und abgewickelt haben, nach UV-Inseln teilen.</translation>
    </message>
    <message>
        <source>Game or character</source>
        <translation>Spiel oder Figur</translation>
    </message>
    <message>
        <source>Export only the garment as OBJ with its UV map. Enter its height when Toile asks. If the texture map is not split like cloth, draw cuts.</source>
        <translation>Nur das Kleidungsstück als OBJ mit seiner UV-Karte exportieren. Geben Sie die Höhe ein, wenn Toile fragt. Ist die Texturkarte nicht wie Stoff geteilt, zeichnen Sie Einschnitte.</translation>
    </message>
    <message>
        <source>Save only the garment as PLY, STL or OBJ, cleaned and reduced to about 100,000 triangles. A scan has no seams: draw them as cuts.</source>
        <translation>Nur das Kleidungsstück als PLY, STL oder OBJ speichern, bereinigt und auf etwa 100 000 Dreiecke verringert. Ein Scan hat keine Nähte: Zeichnen Sie sie als Einschnitte.</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>toile::app::WindowCentre</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
</context>
<context>
    <name>toile::app::WindowDialogs</name>
    <message>
        <source>About Toile</source>
        <translation>Über Toile</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>Dokumentation</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>Ein Problem melden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>The documentation is not installed with the program. See Help &gt; Keyboard and mouse, or hold the pointer over a control for its tool tip.</source>
        <translation>Die Dokumentation ist nicht mit dem Programm installiert. Siehe Hilfe &gt; Tastatur und Maus, oder halten Sie den Zeiger auf ein Bedienelement.</translation>
    </message>
    <message>
        <source>Describe what you did, what you expected and what happened instead. Add these lines and, if you can, the garment&apos;s file.</source>
        <translation>Beschreiben Sie, was Sie getan haben, was Sie erwartet haben und was stattdessen geschah. Fügen Sie diese Zeilen bei und, wenn möglich, die Datei des Kleidungsstücks.</translation>
    </message>
    <message>
        <source>Sewing patterns from 3D garments, with every seam line at its true length. Method: length-preserved natural boundary, Wang (2005).

Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Schnittmuster aus 3D-Kleidungsstücken, mit jeder Nahtlinie in ihrer wahren Länge. Verfahren: längentreuer natürlicher Rand, Wang (2005).

Freie Software unter der GNU General Public License, Version 3 oder neuer.</translation>
    </message>
</context>
<context>
    <name>toile::app::WindowDocks</name>
    <message>
        <source>Pieces</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Probleme (%1)</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Nähprobe</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
</context>
<context>
    <name>toile::app::WindowStatus</name>
    <message>
        <source>%1: cancelled</source>
        <translation>%1: abgebrochen</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Written: %1 (%2 left, see Problems)</source>
        <translation>Geschrieben: %1 (noch %2, siehe Probleme)</translation>
    </message>
    <message>
        <source>%1

Click to choose the unit or to enter the garment&apos;s height</source>
        <translation>%1

Klicken, um die Einheit zu wählen oder die Höhe des Kleidungsstücks einzugeben</translation>
    </message>
</context>
<context>
    <name>toile::app::Workspace</name>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Verfahren ändern</translation>
    </message>
    <message>
        <source>Change quality</source>
        <translation>Güte ändern</translation>
    </message>
    <message>
        <source>Change boundary solver</source>
        <translation>Umrisslöser ändern</translation>
    </message>
    <message>
        <source>Change import options</source>
        <translation>Leseoptionen ändern</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Einheit ändern</translation>
    </message>
    <message>
        <source>Change up axis</source>
        <translation>Achse nach oben ändern</translation>
    </message>
    <message>
        <source>Change splitting into pieces</source>
        <translation>Aufteilung in Schnittteile ändern</translation>
    </message>
    <message>
        <source>Change automatic cuts</source>
        <translation>Selbsttätige Einschnitte ändern</translation>
    </message>
    <message>
        <source>Change welding</source>
        <translation>Verschmelzen ändern</translation>
    </message>
    <message>
        <source>Change closing of slits</source>
        <translation>Schließen der Schlitze ändern</translation>
    </message>
    <message>
        <source>Open reference pattern</source>
        <translation>Referenzschnitt öffnen</translation>
    </message>
    <message>
        <source>Close reference pattern</source>
        <translation>Referenzschnitt schließen</translation>
    </message>
</context>
</TS>
