using System.Numerics;
using Microsoft.Playwright;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Scenes;
using RayTracer.Session;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>How students light a scene, and choose what things are made of.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class LightWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task A_spot_is_chosen_by_its_icon_and_aimed_and_widened_by_its_handles()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await w.Choose("Add", "Light", "spot");
        await w.Page.Keyboard.PressAsync("Escape");
        ILocator icon = w.Page.GetByRole(AriaRole.Button, new() { Name = "Light spot 1" });
        await icon.ClickAsync();
        await Expect(icon).ToHaveAttributeAsync("aria-pressed", "true");
        await w.Painted();
        await w.Shot("spot-handles", isShown: true);

        float before = w.Session.Document.Read.Description!.Lights.OfType<SpotLightDescription>().Single().CutoffAngle;
        await DragHandle(w, "cone", 30, 0);
        await w.Text("the cone has another width", _ => w.Session.Document.Read.Description!.Lights.OfType<SpotLightDescription>().Single().CutoffAngle != before);
        string wide = w.Session.Document.Text;
        await DragHandle(w, "direction", -40, 10);
        await w.Text("the spot is aimed elsewhere", t => t != wide);
        await w.Button("Move").ClickAsync();
        await Expect(w.Page.Locator(".gizmo .axis")).ToHaveCountAsync(3);
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("one step takes the aim back", t => t == wide);
    }

    [SkippableFact]
    public async Task The_lights_of_the_running_picture_are_balanced_and_written_into_the_scene()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        string before = w.Session.Document.Text;
        await w.Tab("Lights");
        await w.Button("Balance lights").ClickAsync();
        ILocator left = w.Page.GetByRole(AriaRole.Slider, new() { Name = "Strength of left front lamp" });
        await left.FillAsync("0.25");
        await w.Page.GetByRole(AriaRole.Slider, new() { Name = "Strength of right back lamp" }).FillAsync("2");
        await StudioWindow.Until("the factors arrive", () => Task.FromResult(w.Session.Mixer.Lights is { } l && l.Any(x => x.Factor.R == 0.25f) && l.Any(x => x.Factor.R == 2)));
        Assert.Equal(before, w.Session.Document.Text);
        await w.Shot("mixer", isShown: true);
        await w.Button("Write into the scene").ClickAsync();
        await w.Text("two lamps have materials of their own", t => t.Contains("\"multiplier\": 2.75", StringComparison.Ordinal) && t.Contains("\"multiplier\": 22", StringComparison.Ordinal));
        await Expect(left).ToHaveValueAsync("1");
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("one step takes it back", t => t == before);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Lights_and_what_surrounds_the_scene_are_added_and_changed()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        foreach (string type in new[] { "point", "directional", "spot" })
        {
            await w.Choose("Add", "Light", type);
            await Expect(w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new($"^{type} 1") })).ToHaveAttributeAsync("aria-selected", "true");
        }

        ILocator cone = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "cutoff angle", Exact = true });
        await cone.FillAsync("25");
        await cone.PressAsync("Enter");
        await Good(w, "the spot is narrower", s => s.Lights.OfType<SpotLightDescription>().Any(l => l.CutoffAngle == 25));

        await w.Choose("Add", "Environment", "sky");
        await Good(w, "there is a sky", s => s.Environment is SkyEnvironmentDescription);
        await Expect(w.Page.GetByText("background", new() { Exact = true })).ToHaveCountAsync(0);
        await w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "sun elevation", Exact = true }).FillAsync("12");
        await w.Page.Keyboard.PressAsync("Enter");
        await Good(w, "the sun is low", s => s.Environment is SkyEnvironmentDescription { SunElevation: 12 });
        await w.Painted(4);
        await w.Shot("sky", isShown: true);

        // A picture of the sky is asked for.
        byte[] pixels = new byte[24];
        byte[] header = System.Text.Encoding.ASCII.GetBytes("PF\n2 1\n-1\n");
        await File.WriteAllBytesAsync(Path.Combine(w.Folder, "scenes", "primer", "panorama.pfm"), [.. header, .. pixels]);
        ILocator environment = w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Environment", Exact = true });
        await environment.SelectOptionAsync("image");
        await w.Page.GetByRole(AriaRole.Dialog).GetByRole(AriaRole.Button, new() { NameRegex = new("panorama") }).DblClickAsync();
        await Good(w, "there is a picture", s => s.Environment is ImageEnvironmentDescription { File: "panorama.pfm" });
        await environment.SelectOptionAsync("constant");
        await Good(w, "light is the same from everywhere", s => s.Environment is ConstantEnvironmentDescription);
        await environment.SelectOptionAsync("");
        await Good(w, "nothing surrounds it", s => s.Environment is null);
        await Expect(w.Page.GetByText("background", new() { Exact = true })).ToHaveCountAsync(1);
    }

    [SkippableFact]
    public async Task A_colour_becomes_a_picture_once_its_file_is_chosen()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene1");
        await w.Painted();
        string before = w.Session.Document.Text;
        const string name = "table";
        await w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new($"^{name} .*diffuse") }).ClickAsync();
        ILocator kinds = w.Page.GetByRole(AriaRole.Combobox, new() { Name = "color: Texture", Exact = true });
        await Expect(kinds).ToHaveValueAsync("color");
        await kinds.SelectOptionAsync("type:image");
        ILocator dialog = w.Page.GetByRole(AriaRole.Dialog);
        await Expect(dialog).ToBeVisibleAsync();
        await w.Page.Keyboard.PressAsync("Escape");
        await Expect(dialog).ToHaveCountAsync(0);
        await Expect(kinds).ToHaveValueAsync("color");
        Assert.Equal(before, w.Session.Document.Text);
        await kinds.SelectOptionAsync("type:image");
        await dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("globe") }).DblClickAsync();
        await Good(w, "it is a picture", s => s.Materials[name] is DiffuseMaterialDescription { Color: Textures.ImageTextureDescription { File: "globe.png" } });
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_material_becomes_each_type_there_is_and_the_scene_stays_good()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        await w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^glass ball") }).ClickAsync();
        await w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^glass .*dielectric") }).ClickAsync();
        ILocator type = w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Type", Exact = true });

        // Last what the next steps change.
        string[] last = ["dielectric", "principled"];
        string[] others = [.. SceneTypes.Materials.Names.Except(last)];
        foreach (string name in others.Where((_, i) => TestSettings.Thorough || (i + TestSettings.Seed) % 5 == 0).Concat(last))
        {
            await type.SelectOptionAsync(name);
            await Good(w, $"the glass is a {name}", s => TypeOf(s.Materials["glass"]) == name);
            if (name == "dielectric")
            {
                ILocator fog = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "extinction red", Exact = true }).Last;
                await fog.FillAsync("2");
                await fog.PressAsync("Enter");
                await Good(w, "there is fog in it", s => s.Materials["glass"] is DielectricMaterialDescription { Interior.Extinction.R: 2 });
                await w.Shot("medium");
            }
        }

        // Where a number may stand, a texture may too.
        ILocator metallic = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "metallic", Exact = true });
        await metallic.FillAsync("0.75");
        await metallic.PressAsync("Enter");
        await w.Text("it is metallic", t => t.Contains("\"metallic\": 0.75", StringComparison.Ordinal));
        ILocator kinds = w.Page.GetByRole(AriaRole.Combobox, new() { Name = "roughness: Texture", Exact = true });
        await kinds.SelectOptionAsync("type:noise");
        await Good(w, "its roughness is noise", s => s.Materials["glass"] is PrincipledMaterialDescription { Roughness: Textures.NoiseTextureDescription });
        await w.Painted();
        await w.Shot("principled", isShown: true);
        await kinds.SelectOptionAsync("number");
        await Good(w, "its roughness is a number", s => s.Materials["glass"] is PrincipledMaterialDescription { Roughness: Textures.SolidTextureDescription });
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Integrator_filter_and_camera_are_chosen_and_the_picture_is_denoised()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere", samples: null);
        await w.Painted();
        await w.Tab("Render");
        async Task Choose(string name, string choice) => await w.Page.GetByRole(AriaRole.Combobox, new() { Name = name, Exact = true }).SelectOptionAsync(choice);
        await Choose("integrator", "path");
        await Choose("shape", "mitchell");
        await Good(w, "paths are traced", s => s.Render is { Integrator.Name: "path", Filter.Shape: FilterShape.Mitchell });
        await w.Tab("Camera");
        await Choose("projection", "orthographic");
        await Good(w, "rays are parallel", s => s.Camera.Projection == Projection.Orthographic);
        await w.Painted();
        await Choose("projection", "perspective");

        // To its end: then only denoising changes what is seen.
        await w.Painted(32);
        byte[] light = await Picture(w);
        await Choose("Show", "denoised");
        await StudioWindow.Until("it is denoised", async () => !(await Picture(w)).SequenceEqual(light));
        Assert.Equal(ViewMap.Denoised, w.Session.View.Settings.Map);
        Assert.Contains(" --denoise ", w.Session.Pictures.Command(), StringComparison.Ordinal);
        await w.Shot("denoised", isShown: true);
    }

    [SkippableFact]
    public async Task A_scene_of_Mitsuba_is_opened_and_saved_as_one_of_its_own()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        string path = Path.Combine(w.Folder, "ball.xml");
        await File.WriteAllTextAsync(path, """
            <scene version="3.0.0">
              <integrator type="path"><integer name="max_depth" value="4"/></integrator>
              <sensor type="perspective">
                <float name="fov" value="40"/>
                <transform name="to_world"><lookat origin="0, 1, 5" target="0, 0, 0" up="0, 1, 0"/></transform>
                <film type="hdrfilm"><integer name="width" value="64"/><integer name="height" value="48"/></film>
              </sensor>
              <shape type="sphere"><bsdf type="roughconductor"><string name="material" value="Au"/></bsdf></shape>
              <emitter type="constant"/>
            </scene>
            """);
        await w.Page.Keyboard.PressAsync("Control+o");
        ILocator dialog = w.Page.GetByRole(AriaRole.Dialog);
        ILocator folder = dialog.GetByRole(AriaRole.Textbox, new() { Name = "Path" });
        await folder.FillAsync(w.Folder);
        await folder.PressAsync("Enter");
        await dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("ball.xml") }).DblClickAsync();
        await Good(w, "it is open", s => s is { Render.Integrator.Name: "path", Background.R: 1 });
        await w.Painted();
        await w.Page.Keyboard.PressAsync("Control+s");
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Save", Exact = true }).ClickAsync();
        string file = Path.Combine(w.Folder, "ball.json");
        await StudioWindow.Until("it is saved", () => Task.FromResult(File.Exists(file)));
        Assert.NotNull(SceneReader.Read(file).Description);
    }

    // Waits until the scene is good, and so.
    private static Task Good(StudioWindow w, string what, Func<SceneDescription, bool> isSo) => StudioWindow.Until(what, () =>
    {
        DocumentContent content = w.Session.Document.Content;
        bool isNew = content.Revision == w.Session.Document.Revision && content.LastGood?.Revision == content.Revision;
        return Task.FromResult(isNew && isSo(content.LastGood!.Read.Description!));
    });

    private static string TypeOf(MaterialDescription material) => RecordType.Of(material.GetType()).Name;

    private static Task<byte[]> Picture(StudioWindow w) => w.Canvas.ScreenshotAsync();

    // Ends when the server has answered for the place where the pointer was let go: before, more of the gesture is on its way.
    private static async Task DragHandle(StudioWindow w, string name, float dx, float dy)
    {
        LocatorBoundingBoxResult box = (await w.Page.Locator($".lights [data-handle={name}]").BoundingBoxAsync())!;
        LocatorBoundingBoxResult canvas = (await w.Canvas.BoundingBoxAsync())!;
        (float x, float y) = (box.X + (box.Width / 2), box.Y + (box.Height / 2));
        float scale = w.Session.View.RequireShown().Scene.Render.Width / canvas.Width;
        Vector2 end = new Vector2(x + dx - canvas.X, y + dy - canvas.Y) * scale;
        await w.Page.RunAndWaitForRequestFinishedAsync(
            async () =>
            {
                await w.Page.Mouse.MoveAsync(x, y);
                await w.Page.Mouse.DownAsync();
                await w.Page.Mouse.MoveAsync(x + dx, y + dy, new() { Steps = 5 });
                await w.Page.Mouse.UpAsync();
            },
            new() { Predicate = request => request.Url.Contains("/view/light/drag", StringComparison.Ordinal) && Vector2.Distance(To(request), end) < 1.5f });

        static Vector2 To(IRequest request) =>
            System.Text.Json.Nodes.JsonNode.Parse(request.PostData!)!["to"]!.AsArray() is var to ? new((float)to[0]!, (float)to[1]!) : default;
    }
}
