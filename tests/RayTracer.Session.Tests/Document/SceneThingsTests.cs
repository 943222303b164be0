using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Adding, copying, deleting and renaming things, with all that refers to them.</summary>
public sealed class SceneThingsTests
{
    public static TheoryData<string> Scenes => ShippedScenes.All;

    public static TheoryData<string, string> New
    {
        get
        {
            TheoryData<string, string> all = [];
            foreach ((string family, TypeFamily types) in new[] { ("shape", SceneTypes.Shapes), ("light", SceneTypes.Shapes), ("material", SceneTypes.Materials), ("texture", SceneTypes.Textures) })
            {
                foreach (string type in types.Names.Where(t => t is not ("model" or "image") && (family != "light" || t is not ("group" or "instance"))))
                {
                    all.Add(family, type);
                }
            }

            return all;
        }
    }

    [Theory]
    [MemberData(nameof(New))]
    public void What_is_added_is_good_and_called_by_a_free_name(string family, string type)
    {
        JsonText text = JsonText.Of(ShippedScenes.Text("meshes/01-cube.json"));
        (text, string first) = SceneThings.Add(text, family, type);
        (text, string second) = SceneThings.Add(text, family, type);
        Assert.NotEqual(first, second);
        Assert.Equal(type, text.At(second + "/type").Text);
        SceneLoadResult load = SceneLoader.Build(SceneReader.ReadText(text.Text, "scene"), "");
        Assert.True(load.Scene is not null, $"{Diagnostic.Format(load.Diagnostics)}\n{text.Text}");
    }

    [Fact]
    public void What_is_offered_as_a_light_lights_the_scene()
    {
        IReadOnlyList<CatalogueType> shapes = TypeCatalogue.Instance.Types["shape"];
        string[] offered = [.. shapes.Where(t => t.AddedAs.Contains("light")).Select(t => t.Name)];
        Assert.Empty(new[] { "sphere", "disk", "rectangle", "plane", "triangle", "box", "cylinder", "cone", "torus", "point", "spot", "directional" }.Except(offered));
        Assert.Empty(new[] { "sphere", "torus", "plane", "model", "instance" }.Except(shapes.Where(t => t.AddedAs.Contains("shape")).Select(t => t.Name)));
        Assert.All(offered, type =>
        {
            (JsonText text, _) = SceneThings.Add(JsonText.Of("{}"), "light", type);
            SceneLoadResult load = SceneLoader.Build(SceneReader.ReadText(text.Text, "scene"), "");
            Assert.True(load.Scene?.Lights.Count == 1, $"{Diagnostic.Format(load.Diagnostics)}\n{text.Text}");
        });
    }

    [Theory]
    [InlineData("point")]
    [InlineData("spot")]
    [InlineData("directional")]
    public void A_light_without_extent_is_put_up_where_it_lights_what_the_camera_looks_at(string type)
    {
        JsonText text = JsonText.Of("{ \"camera\": { \"position\": [0, 0, 5], \"lookAt\": [0, 0, 0] } }");
        (text, string pointer) = SceneThings.Add(text, "light", type);
        SceneDescription scene = SceneReader.ReadText(text.Text, "scene").Description!;
        Assert.Equal("/lights/0", pointer);
        switch (scene.Lights.Single())
        {
            case PointLightDescription point:
                Assert.True(point.Position.Y > 0 && point.Position.Z is > 0 and < 5);
                break;
            case SpotLightDescription spot:
                Assert.InRange(Vector3.Dot(Vector3.Normalize(spot.Direction), Vector3.Normalize(-spot.Position)), 0.999f, 1.001f);
                break;
            case DirectionalLightDescription directional:
                Assert.True(directional.Direction.Y < 0 && directional.Direction.Z < 0);
                break;
        }
    }

    [Fact]
    public void New_things_are_as_large_as_parallel_rays_show_them()
    {
        JsonText text = JsonText.Of("{ \"camera\": { \"position\": [0, 0, 500], \"lookAt\": [0, 0, 0], \"projection\": \"orthographic\", \"viewSize\": 8 } }");
        (text, string pointer) = SceneThings.Add(text, "shape", "sphere");
        Assert.Equal("1", text.At(pointer + "/radius").Text);
    }

    [Fact]
    public void An_environment_takes_the_place_of_the_one_before_and_of_the_background()
    {
        JsonText text = JsonText.Of("{ \"background\": \"skyblue\" }");
        (text, string pointer) = SceneThings.Add(text, "environment", "constant");
        (text, _) = SceneThings.Add(text, "environment", "sky");
        Assert.Equal("/environment", pointer);
        SceneLoadResult load = SceneLoader.Build(SceneReader.ReadText(text.Text, "scene"), "");
        Assert.Equal("", Diagnostic.Format(load.Diagnostics));
        Assert.IsType<SkyEnvironmentDescription>(load.Description!.Environment);
    }

    [Fact]
    public void What_lacks_a_file_or_an_object_is_refused()
    {
        JsonText text = JsonText.Of("{}");
        Assert.Throws<SessionException>(() => SceneThings.Add(text, "shape", "model"));
        Assert.Throws<SessionException>(() => SceneThings.Add(text, "texture", "image"));
        Assert.Throws<SessionException>(() => SceneThings.Add(text, "shape", "instance"));
        Assert.Throws<SessionException>(() => SceneThings.Add(text, "shape", "teapot"));
        Assert.Throws<SessionException>(() => SceneThings.Add(text, "smell", "rose"));
        Assert.Contains("\"file\": \"a.png\"", SceneThings.Add(text, "texture", "image", file: "a.png").Text.Text, StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Renaming_any_definition_keeps_all_references(string path)
    {
        JsonText text = JsonText.Of(ShippedScenes.Text(path));
        string before = Canonical(text, path);
        foreach (string section in new[] { "materials", "textures", "objects" })
        {
            foreach (string name in text.Root.Find(section)?.Members.Select(m => m.Key).ToArray() ?? [])
            {
                (JsonText renamed, string pointer) = SceneThings.Rename(text, JsonPointer.Of(section, name), "a/b~\"c\"");
                Assert.NotEqual(before, Canonical(renamed, path));
                (JsonText back, _) = SceneThings.Rename(renamed, pointer, name);
                Assert.Equal(text.Text, back.Text);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    [Trait("Category", "Thorough")]
    public void Deleting_any_one_thing_leaves_a_scene_without_errors(string path)
    {
        JsonText text = JsonText.Of(ShippedScenes.Text(path));
        string[] sections = ["shapes", "lights", "materials", "textures", "objects"];
        string[] things = [.. JsonEditTests.Pointers(text.Root, "").Where(p => JsonPointer.Parse(p) is [var section, _] && sections.Contains(section))];

        // Every day, some twenty of scenes of many things.
        int step = 1 + (things.Length / TestSettings.Scale(20, 10000));
        foreach (string pointer in things.Where((_, i) => i % step == TestSettings.Seed % step))
        {
            (JsonText left, IReadOnlyList<string> notes) = SceneThings.Delete(text, [pointer]);
            SceneReadResult read = SceneReader.ReadText(left.Text, path);
            Assert.True(read.Description is not null, $"{pointer}: {Diagnostic.Format(read.Diagnostics)}");
            TypeFamily? family = SceneReferences.DefinedAt(pointer);
            Assert.Equal(family is not null && SceneReferences.To(text.Root, family, JsonPointer.Last(pointer)).Any(), notes.Count > 0);
        }
    }

    [Fact]
    public void Several_things_are_deleted_at_once_whatever_goes_with_them()
    {
        JsonText text = JsonText.Of("""
            { "objects": { "o": { "type": "sphere", "center": [0, 0, 0] } },
              "shapes": [{ "type": "instance", "of": "o" }, { "type": "sphere", "name": "keep", "center": [1, 0, 0] }, { "type": "sphere", "center": [2, 0, 0] }] }
            """);
        (JsonText left, IReadOnlyList<string> notes) = SceneThings.Delete(text, ["/objects/o", "/shapes/0", "/shapes/2"]);
        Assert.Equal("keep", left.At("/shapes").Items.Single().Find("name")!.Text);
        Assert.Empty(notes);
        Assert.Throws<SessionException>(() => SceneThings.Delete(text, ["/shapes/1/center"]));
        Assert.Throws<SessionException>(() => SceneThings.Delete(text, ["/shapes/7"]));
    }

    [Fact]
    public void Animations_follow_what_they_animate()
    {
        JsonText text = JsonText.Of("""
            { "materials": { "a b": { "type": "diffuse", "color": [1, 0, 0] } },
              "shapes": [{ "type": "sphere", "center": [0, 0, 0] }, { "type": "sphere", "name": "ball", "center": [1, 0, 0], "material": "a b" }, { "type": "sphere", "center": [2, 0, 0] }],
              "animation": [
                { "property": "materials.a b.color", "keys": [{ "time": 0, "value": [0, 0, 0] }] },
                { "property": "shapes.ball.center[1]", "keys": [{ "time": 0, "value": 1 }] },
                { "property": "shapes[2].radius", "keys": [{ "time": 0, "value": 1 }] } ] }
            """);
        Assert.Equal(["materials.c.color", "shapes.ball.center[1]", "shapes[2].radius"], Tracks(SceneThings.Rename(text, "/materials/a b", "c").Text));
        Assert.Equal(["materials[\"1.5\"].color", "shapes.ball.center[1]", "shapes[2].radius"], Tracks(SceneThings.Rename(text, "/materials/a b", "1.5").Text));
        Assert.Equal(["materials.a b.color", "shapes.globe.center[1]", "shapes[2].radius"], Tracks(SceneThings.Rename(text, "/shapes/1", "globe").Text));
        Assert.Equal(["materials.a b.color", "shapes[1].center[1]", "shapes[2].radius"], Tracks(SceneThings.Rename(text, "/shapes/1", "").Text));
        Assert.Equal(["materials.a b.color", "shapes.ball.center[1]", "shapes[1].radius"], Tracks(SceneThings.Delete(text, ["/shapes/0"]).Text));
        Assert.Equal(["materials.a b.color", "shapes[1].radius"], Tracks(SceneThings.Delete(text, ["/shapes/1"]).Text));
        Assert.Equal(["shapes.ball.center[1]", "shapes[2].radius"], Tracks(SceneThings.Delete(text, ["/materials/a b"]).Text));
        Assert.Equal(["materials.a b.color", "shapes.ball.center[1]", "shapes[3].radius"], Tracks(SceneThings.Duplicate(text, "/shapes/0").Text));

        static string[] Tracks(JsonText text)
        {
            SceneReadResult read = SceneReader.ReadText(text.Text, "");
            Assert.True(read.Description is not null, Diagnostic.Format(read.Diagnostics));
            return [.. read.Description.Animation.Select(t => t.Property)];
        }
    }

    [Fact]
    public void Copies_have_names_and_places_of_their_own()
    {
        JsonText text = JsonText.Of("""
            {
              "materials": { "glass 2": { "type": "dielectric" }, "r2d2": { "type": "diffuse" } },
              "shapes": [
                { "type": "sphere", "name": "ball", "center": [0, 0, 0] }, // a ball
              ],
            }
            """);
        (text, string copy) = SceneThings.Duplicate(text, "/shapes/0");
        (text, string again) = SceneThings.Duplicate(text, copy);
        Assert.Equal(("/shapes/1", "ball 2", "/shapes/2", "ball 3"), (copy, text.At(copy + "/name").Text, again, text.At(again + "/name").Text));
        Assert.NotEqual(0, SceneValue.At(text.Root, copy)!.Vector("center").X);
        Assert.Contains("[0, 0, 0] }, // a ball\n    { \"type\": \"sphere\", \"name\": \"ball 2\"", text.Text, StringComparison.Ordinal);
        Assert.Equal("/materials/glass 3", SceneThings.Duplicate(text, "/materials/glass 2").Pointer);
        Assert.Equal("/materials/r2d2 2", SceneThings.Duplicate(text, "/materials/r2d2").Pointer);
    }

    [Fact]
    public void Names_that_cannot_be_are_refused()
    {
        JsonText text = JsonText.Of("""{ "materials": { "a": { "type": "diffuse" }, "b": "a" }, "textures": { "t": [1, 1, 1] }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": "a" }] }""");
        Assert.Throws<SessionException>(() => SceneThings.Rename(text, "/materials/a", "b"));
        Assert.Throws<SessionException>(() => SceneThings.Rename(text, "/materials/a", ""));
        Assert.Throws<SessionException>(() => SceneThings.Rename(text, "/textures/t", "red"));
        Assert.Throws<SessionException>(() => SceneThings.Rename(text, "/textures/t", "#123"));
        Assert.Throws<SessionException>(() => SceneThings.Rename(text, "/camera", "x"));
        Assert.Equal("c", SceneThings.Rename(text, "/materials/a", "c").Text.At("/shapes/0/material").Text);
        (JsonText named, _) = SceneThings.Rename(text, "/shapes/0", "ball");
        Assert.Equal("ball", named.At("/shapes/0/name").Text);
        Assert.Equal(text.Text, SceneThings.Rename(named, "/shapes/0", "").Text.Text);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void The_outline_lists_everything_once(string path)
    {
        SceneReadResult read = SceneReader.Read(Path.Combine(ShippedScenes.Folder, path));
        Outline outline = Outline.Of(1, read.Root!);
        SceneDescription scene = read.Description!;
        Assert.Equal(
            (scene.Shapes.Count, scene.Lights.Count, scene.Materials.Count, scene.Textures.Count, scene.Objects.Count),
            (outline.Shapes.Count, outline.Lights.Count, outline.Materials.Count, outline.Textures.Count, outline.Objects.Count));
        OutlineNode[] all = [.. outline.Shapes, .. outline.Lights, .. outline.Materials, .. outline.Textures, .. outline.Objects];
        Assert.All(all, n => Assert.Equal(n.Type, SceneValue.At(read.Root!, n.Pointer)!.Resolved(read.Root!).Type?.Name ?? "solid"));
        Assert.All(outline.Lights.Where(l => l.Type != "instance"), l => Assert.True(l.IsLight || l.Type is "model" or "group"));
        Assert.All(all.Where(n => n.Color is not null), n => Assert.Matches("^#[0-9a-f]{6}$", n.Color));
    }

    private static string Canonical(JsonText text, string path)
    {
        SceneReadResult read = SceneReader.ReadText(text.Text, path);
        Assert.True(read.Description is not null, Diagnostic.Format(read.Diagnostics));
        return SceneWriter.Write(read.Description);
    }
}
