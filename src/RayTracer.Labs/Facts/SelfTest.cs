using System.Reflection;
using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>A class that was tested.</summary>
/// <param name="Name">Its name; with that in scene files, where it has one.</param>
/// <param name="Facts">What was found.</param>
public sealed record TestedClass(string Name, IReadOnlyList<Fact> Facts)
{
    /// <summary>True where all facts hold.</summary>
    public bool Holds => Facts.All(f => f.Holds);
}

/// <summary>
/// The facts about all materials, shapes and lights that an assembly defines: those that records of scene files describe, with the default values of
/// their parameters, and those that have a constructor without parameters.
/// </summary>
public static class SelfTest
{
    // Single precision, near the horizon.
    private const double SingleRounding = 1e-3;

    // Lights without a record are looked for around the origin.
    private static readonly Bounds s_place = new(new(-5, -5, -5), new(5, 5, 5));

    /// <summary>Tests an assembly.</summary>
    /// <param name="assembly">The assembly.</param>
    /// <param name="seed">Of the random numbers.</param>
    /// <param name="report">Takes each class as soon as it is tested; may be null.</param>
    public static IReadOnlyList<TestedClass> Of(Assembly assembly, long seed = 1, Action<TestedClass>? report = null)
    {
        List<TestedClass> all = [];
        foreach (Type type in assembly.GetExportedTypes().Where(t => t is { IsClass: true, IsAbstract: false } && t.GetConstructor([]) is not null).OrderBy(t => t.FullName, StringComparer.Ordinal))
        {
            if (FactsOf(type, seed) is { } facts)
            {
                TestedClass tested = new(NameOf(type), facts);
                all.Add(tested);
                report?.Invoke(tested);
            }
        }

        return all;
    }

    // Null where it is nothing that can be tested.
    private static IReadOnlyList<Fact>? FactsOf(Type type, long seed)
    {
        Type[] kinds = [typeof(IOwnMaterial), typeof(IOwnShape), typeof(IMaterial), typeof(IShape), typeof(ILight), typeof(MaterialDescription)];
        if (!Array.Exists(kinds, k => k.IsAssignableFrom(type)))
        {
            return null;
        }

        SceneBuilder builder = new((_, _) => new Textures.Picture(1, 1));
        Func<IReadOnlyList<Fact>>? test = null;
        Fact made = Fact.Of("it can be made", "It can be made.", ["with the default values"], _ =>
        {
            test = TestOf(Activator.CreateInstance(type)!, builder, seed);
            return builder.Complaints is [var complaint, ..] ? Fact.Wrong($"{complaint.Message}.") : null;
        });
        return made.Holds ? test!() : [made];
    }

    private static Func<IReadOnlyList<Fact>> TestOf(object thing, SceneBuilder builder, long seed)
    {
        switch (thing)
        {
            case IOwnMaterial own:
                IMaterial material = own.Make(TextbookMaterialDescription.TexturesOf(own, builder));
                return new MaterialFacts(material, new() { ReciprocityException = (own as TextbookMaterialDescription)?.ReciprocityException }, seed).All;
            case IOwnShape own:
                return new ShapeFacts(own.Make(), seed).All;
            case IMaterial own:
                return new MaterialFacts(own, null, seed).All;
            case IShape own:
                return new ShapeFacts(own, seed).All;
            case ILight own:
                return new LightFacts(own, s_place, seed).All;
            default:
                Material fast = builder.Material((MaterialDescription)thing);
                MaterialClaims claims = new()
                {
                    ReciprocityException = fast.Traits.Transmits ? "what goes through the surface has an index that is not known here" : fast.Traits.ReciprocityException,
                    EnergyException = fast.Traits.Transmits || fast.Traits.Specular == SpecularLobe.Delta ? "radiance grows in a denser medium" : fast.Traits.EnergyException,
                    Rounding = SingleRounding,
                    ListsMirrors = false,
                };
                return new MaterialFacts(new LaneMaterial(fast), claims, seed).All;
        }
    }

    private static string NameOf(Type type) => type.GetCustomAttribute<SceneTypeAttribute>() is { } named ? $"{type.Name} (\"{named.Name}\")" : type.Name;
}
