using System.Collections.Immutable;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>
/// Balances the lights of the picture that is being rendered, at once and without a ray: its light is kept for each of them from the first sample on. The
/// film knows nothing of that; what has been found can be written into the scene.
/// </summary>
/// <param name="document">The document.</param>
/// <param name="view">Shows it.</param>
public sealed class LightMixer(SceneDocument document, PictureView view)
{
    private const float MostFactor = 1e6f;

    // What is written differs by no more than this part of it, which nobody sees.
    private const float Precise = 1e-3f;

    /// <summary>The lights with their factors; null where they are not kept apart.</summary>
    public IReadOnlyList<MixedLight>? Lights => view.Settings.LightFactors is { } factors && view.Shown is { } shown
        ? [.. LightLayers.NamesOf(shown).Select(name => new MixedLight(name, FactorOf(factors, name), [.. SourcesOf(shown, name).Select(shown.PointerOf).OfType<string>()]))] : null;

    /// <summary>Multiplies the light of some lights; the picture is rendered again only where it was not kept apart before.</summary>
    /// <param name="factors">The factors on lights: red, green and blue; others are 1. Null ends it.</param>
    /// <exception cref="SessionException">The scene's lights cannot be kept apart, or a factor is out of range.</exception>
    public void Mix(IReadOnlyDictionary<string, float[]>? factors)
    {
        if (factors?.Values.All(f => f.Length == 3 && f.All(x => x is >= 0 and <= MostFactor)) == false)
        {
            throw new SessionException("Lights are multiplied by three numbers from 0 to 1000000.");
        }

        bool begins = factors is not null && view.Settings.LightFactors is null;
        if (begins)
        {
            LightLayers.Check(view.RequireShown());
        }

        view.Change(s => s with { LightFactors = factors?.ToImmutableDictionary(f => f.Key, f => new Rgb(f.Value[0], f.Value[1], f.Value[2])) }, restart: begins);
    }

    /// <summary>Writes the factors into the scene, as one step to undo; they are 1 then.</summary>
    /// <returns>The text's revision then.</returns>
    /// <exception cref="SessionException">A light's strength is not in the text as a number or a colour.</exception>
    public int Write()
    {
        ViewportScene shown = view.RequireShown();
        ImmutableDictionary<string, Rgb> factors = view.Settings.LightFactors ?? [];
        int revision = document.Change("balance lights", null, text => factors.Where(f => f.Value != Rgb.White).Aggregate(text, (now, f) => Scaled(shown, now, f.Key, f.Value)));
        view.Change(s => s with { LightFactors = [] });
        return revision;
    }

    private static Rgb FactorOf(ImmutableDictionary<string, Rgb> factors, string name) => factors.TryGetValue(name, out Rgb factor) ? factor : Rgb.White;

    private static IEnumerable<ShapeDescription> SourcesOf(ViewportScene shown, string name) =>
        shown.Description.Lights.Concat(shown.Description.Shapes.Where(s => s.Material is LuminaireMaterialDescription)).Where(s => LightLayers.NameOf(s) == name);

    private static JsonText Scaled(ViewportScene shown, JsonText text, string name, Rgb factor)
    {
        SceneDescription scene = shown.Description;
        ShapeDescription[] sources = [.. SourcesOf(shown, name)];
        if (sources.Length > 0)
        {
            return sources.Aggregate(text, (now, source) => Scaled(shown, now, source, factor));
        }

        return name switch
        {
            _ when scene.Environment is { } around && LightLayers.NameOf(around) == name => Scaled(text, around, factor),
            LightLayers.Background => Set(text, "/background", scene.Background * factor),
            LightLayers.Ambient => Set(text, "/ambient", scene.Ambient * factor),
            _ => throw Unwritable(name),
        };
    }

    private static JsonText Scaled(ViewportScene shown, JsonText text, ShapeDescription source, Rgb factor)
    {
        string pointer = shown.PointerOf(source) ?? throw Unwritable(source.Name);
        return source switch
        {
            PointLightDescription light => Set(text, $"{pointer}/intensity", light.Intensity * factor),
            SpotLightDescription light => Set(text, $"{pointer}/intensity", light.Intensity * factor),
            DirectionalLightDescription light => Set(text, $"{pointer}/irradiance", light.Irradiance * factor),
            { Material: LuminaireMaterialDescription luminaire } when shown.PointerOf(luminaire) is { } material => Scaled(Own(text, material, $"{pointer}/material"), $"{pointer}/material", luminaire, factor),
            _ => throw Unwritable(source.Name),
        };
    }

    // A material that has a name may be others' too: the light gets one of its own.
    private static JsonText Own(JsonText text, string material, string pointer) =>
        material == pointer ? text : text.SetText(pointer, text.Text[text.At(material).Start..text.At(material).End]);

    private static JsonText Scaled(JsonText text, string pointer, LuminaireMaterialDescription luminaire, Rgb factor)
    {
        if (factor.R == factor.G && factor.G == factor.B)
        {
            return Set(text, $"{pointer}/multiplier", luminaire.Multiplier * factor.R);
        }

        return luminaire.Color is SolidTextureDescription { Color: var color } ? Set(text, $"{pointer}/color", color * factor)
            : throw new SessionException("A light with a picture or pattern can be made brighter or darker, but gets no other colour.");
    }

    private static JsonText Scaled(JsonText text, EnvironmentDescription around, Rgb factor) => (around, factor.R == factor.G && factor.G == factor.B) switch
    {
        (ConstantEnvironmentDescription constant, _) => Set(text, "/environment/radiance", constant.Radiance * factor),
        (ImageEnvironmentDescription image, true) => Set(text, "/environment/scale", image.Scale * factor.R),
        (SkyEnvironmentDescription sky, true) => Set(text, "/environment/scale", sky.Scale * factor.R),
        _ => throw new SessionException("An environment with a picture or a sky can be made brighter or darker, but gets no other colour."),
    };

    private static JsonText Set(JsonText text, string pointer, float value) => text.Set(pointer, JsonValues.Number(Rounded(value)));

    private static JsonText Set(JsonText text, string pointer, Rgb color) =>
        text.Set(pointer, new JsonArray(JsonValues.Number(Rounded(color.R)), JsonValues.Number(Rounded(color.G)), JsonValues.Number(Rounded(color.B))));

    private static float Rounded(float value) => Precision.Round(value, Precise * MathF.Abs(value));

    private static SessionException Unwritable(string name) => new($"The light of \"{name}\" has its strength in a group or an object: change it there.");
}

/// <summary>A light of the picture, or several with one name.</summary>
/// <param name="Name">The name of its layer.</param>
/// <param name="Factor">The factor on its light, for red, green and blue.</param>
/// <param name="Pointers">Those of them that stand in the text by themselves: not in a group or an object.</param>
public sealed record MixedLight(string Name, Rgb Factor, IReadOnlyList<string> Pointers);
