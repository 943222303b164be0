using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session.Tests;

/// <summary>Parameters that are folded away have no effect on the picture, and exist.</summary>
public sealed class IdleFieldsTests
{
    private const string Scene = """
        {
          "camera": { "position": [0, 1, 4], "lookAt": [0, 0.5, 0], "lens": {} },
          "render": { "width": 12, "height": 8, "samplesPerPixel": 4, "filter": {} },
          "background": [0.2, 0.3, 0.4],
          "materials": {
            "paint": { "type": "principled", "specular": 0.5 },
            "frosted": { "type": "roughDielectric", "alphaU": 0.2, "alphaV": 0.1 },
            "brushed": { "type": "roughConductor", "alphaU": 0.2, "alphaV": 0.1 },
            "cloud": { "type": "diffuse", "color": { "type": "noise" } },
            "stone": { "type": "diffuse", "color": { "type": "marble", "turbulence": 0 } },
            "plank": { "type": "diffuse", "color": { "type": "wood", "turbulence": 0 } },
          },
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "cloud" },
            { "type": "sphere", "center": [-1.5, 0.5, 0], "radius": 0.5, "material": "paint" },
            { "type": "sphere", "center": [-0.5, 0.5, 0], "radius": 0.5, "material": "frosted" },
            { "type": "sphere", "center": [0.5, 0.5, 0], "radius": 0.5, "material": "brushed" },
            { "type": "sphere", "center": [1.5, 0.5, 0], "radius": 0.5, "material": "stone" },
            { "type": "sphere", "center": [0, 1.5, -1], "radius": 0.5, "material": "plank" },
          ],
          "lights": [
            { "type": "sphere", "center": [0, 4, 2], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 10 } },
            { "type": "spot", "position": [2, 3, 2], "direction": [-1, -1.5, -1], "intensity": [9, 9, 9] },
          ],
        }
        """;

    [Fact]
    public void Every_name_in_the_rules_exists()
    {
        Assert.All(IdleFields.Rules, rule =>
        {
            RecordType record = Assert.Single(SceneTypes.All, t => t.Name == rule.Record);
            Assert.All(rule.Parameters, key => Assert.NotNull(record.Find(key)));
            Assert.NotEmpty(rule.Reason);
        });
        Assert.Contains(IdleFields.Rules, r => r.Reason == "Only with the integrator photons or vcm.");
    }

    public static TheoryData<string, string> Settings => new()
    {
        { "path", "" }, { "direct", "" }, { "volPath", "" }, { "report", "" }, { "vcm", "" }, { "ao", "" }, { "normals", "" }, { "light", "" },
        { "path", "orthographic" }, { "path", "spherical" }, { "path", "lens" }, { "path", "eyeJitter" }, { "path", "tent" },
    };

    [Theory]
    [MemberData(nameof(Settings))]
    public void What_has_no_effect_changes_no_bit(string integrator, string more)
    {
        JsonText text = JsonText.Of(Scene).Set("/render/integrator", integrator);
        text = more switch
        {
            "lens" => text.Set("/camera/lens/apertureRadius", 0.2),
            "eyeJitter" => text.Set("/camera/lens/shape", "eyeJitter"),
            "tent" => text.Set("/render/filter/shape", "tent"),
            "" => text,
            _ => text.Set("/camera/projection", more),
        };
        IReadOnlyDictionary<string, string> idle = IdleFields.Of(text.Root);
        Assert.NotEmpty(idle);
        string expected = HashOf(text);
        JsonText changed = idle.Keys.Where(k => k != "/camera/lens/focusDistance").Aggregate(text, (t, pointer) => Other(SceneValue.At(t.Root, pointer)!) is { } other ? t.Set(pointer, other) : t);
        Assert.True(changed.Text != text.Text);
        Assert.True(expected == HashOf(changed), $"One of {string.Join(", ", idle.Keys)} has an effect.");
    }

    [Fact]
    public void What_has_an_effect_is_not_folded_away()
    {
        Assert.False(Idle("vcm").ContainsKey("/render/mergeRadius"));
        Assert.True(Idle("path").ContainsKey("/render/mergeRadius"));
        Assert.False(Idle("ao").ContainsKey("/render/occlusionDistance"));
        Assert.True(Idle("path").ContainsKey("/camera/lens/focusDistance"));
        Assert.False(IdleFields.Of(JsonText.Of(Scene).Set("/camera/lens/apertureRadius", 0.2).Root).ContainsKey("/camera/lens/focusDistance"));
        Assert.Equal("This light has no surface.", Idle("path")["/lights/1/material"]);
        Assert.False(Idle("path").ContainsKey("/lights/0/material"));
        Assert.Equal("The sheen is 0.", Idle("path")["/materials/paint/sheenTint"]);
        Assert.False(IdleFields.Of(JsonText.Of(Scene).Set("/materials/paint/sheen", "cloudy").Root).ContainsKey("/materials/paint/sheenTint"));

        // Nor what is animated, and what goes by that.
        JsonObject track = new() { ["property"] = "camera.lens.apertureRadius", ["keys"] = new JsonArray(new JsonObject { ["time"] = 0, ["value"] = 0 }) };
        Assert.False(IdleFields.Of(JsonText.Of(Scene).Set("/animation", new JsonArray(track)).Root).ContainsKey("/camera/lens/focusDistance"));
        Assert.Contains("/render/mergeRadius", Outline.Of(1, JsonText.Of("{}").Root).Idle.Keys);

        static IReadOnlyDictionary<string, string> Idle(string integrator) => IdleFields.Of(JsonText.Of(Scene).Set("/render/integrator", integrator).Root);
    }

    private static string HashOf(JsonText text)
    {
        SceneLoadResult load = SceneLoader.LoadText(text.Text, "scene.json", "");
        Assert.True(load.Scene is not null, $"{Diagnostic.Format(load.Diagnostics)}\n{text.Text}");
        return new RTracer(load.Scene).Render().Film.ComputeHash();
    }

    // Another value that is allowed; null where a test cannot tell one.
    private static System.Text.Json.Nodes.JsonNode? Other(SceneValue value)
    {
        RecordParameter p = value.Parameter!;
        if (p.Choices.Count > 0)
        {
            return JsonValue.Create(p.Choices[^1] == value.Node?.Text ? p.Choices[0] : p.Choices[^1]);
        }

        // Errors, not warnings, say that these do nothing: with integrators that trace light, and beside specular.
        bool isRefused = p.Key is "maxDiffuseDepth" or "maxSpecularDepth" or "weakenedShadows" or "sphereLightSampling" or "refractiveIndex";
        return isRefused || value.Family?.Noun == "material" || p.RecordType is not null ? null
            : p.Default switch
            {
                bool flag => JsonValue.Create(!flag),
                System.Numerics.Vector3 => new JsonArray(0.25, 0.5, 0.75),
                _ when p.Minimum > 0 => JsonValue.Create(p.Minimum + 2),
                _ => JsonValue.Create(1),
            };
    }
}
