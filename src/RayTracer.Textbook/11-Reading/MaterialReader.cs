using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Textures;

namespace RayTracer.Textbook;

/// <summary>Turns descriptions of materials and textures into what scatters light. The same record gives the same object.</summary>
/// <param name="refusals">Takes what there is none of.</param>
/// <param name="loadPicture">Reads the picture file of a path; raw where the second argument says so.</param>
internal sealed class MaterialReader(Refusals refusals, Func<string, bool, Picture> loadPicture)
{
    private const string Known = "diffuse, dielectric, conductor, roughConductor (with GGX), phong, phongMetal, diffuseSpecular, luminaire, and oneSided and twoSided ones";
    private readonly Dictionary<object, IMaterial> _materials = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<(object, bool), ITexture> _textures = [];

    // Of the metals that scenes name: red, green and blue of the refractive index and of the extinction (Palik 1985), as in the scene format.
    private static readonly Dictionary<Metal, (Rgb Eta, Rgb K)> s_metals = new()
    {
        [Metal.None] = (Rgb.Black, Rgb.Black),
        [Metal.Aluminium] = (new(1.6575, 0.880405, 0.521244), new(9.22381, 6.2695, 4.837)),
        [Metal.Copper] = (new(0.201005, 0.92375, 1.10222), new(3.91326, 2.45305, 2.14209)),
        [Metal.Gold] = (new(0.143036, 0.375307, 1.44205), new(3.983, 2.38556, 1.60336)),
        [Metal.Silver] = (new(0.155276, 0.116728, 0.138388), new(4.82835, 3.12222, 2.1469)),
    };

    /// <summary>The material of a record; of a luminaire, that which reflects.</summary>
    public IMaterial Material(MaterialDescription description)
    {
        if (!_materials.TryGetValue(description, out IMaterial? material))
        {
            material = Read(description);
            _materials.Add(description, material);
        }

        return material;
    }

    /// <summary>How a material shines; null where it does not.</summary>
    public Luminaire? Luminaire(MaterialDescription description) =>
        description is LuminaireMaterialDescription l ? new(Texture(l.Color), l.Multiplier, l.Exponent) : null;

    /// <summary>The texture of a record.</summary>
    /// <param name="description">The record.</param>
    /// <param name="isNumber">True where its red channel is a number: then pictures are read as they are.</param>
    public ITexture Texture(TextureDescription description, bool isNumber = false)
    {
        if (!_textures.TryGetValue((description, isNumber), out ITexture? texture))
        {
            texture = Read(description, isNumber);
            _textures.Add((description, isNumber), texture);
        }

        return texture;
    }

    private IMaterial Read(MaterialDescription description)
    {
        switch (description)
        {
            case DiffuseMaterialDescription d:
                refusals.Rest(d, nameof(d.Color));
                return new Diffuse(Texture(d.Color));
            case DielectricMaterialDescription d:
                refusals.Rest(d, nameof(d.RefractiveIndex), nameof(d.Extinction), nameof(d.Fresnel), nameof(d.SpecularReflectance), nameof(d.SpecularTransmittance));
                return new Dielectric(
                    d.RefractiveIndex, d.Extinction, d.Fresnel == FresnelModel.Schlick, Texture(d.SpecularReflectance), Texture(d.SpecularTransmittance));
            case ConductorMaterialDescription c:
                refusals.Rest(c, nameof(c.Metal), nameof(c.Eta), nameof(c.K), nameof(c.SpecularReflectance));
                return new Conductor(Reflectance(c));
            case RoughConductorMaterialDescription r:
                refusals.Rest(r, nameof(r.Metal), nameof(r.Eta), nameof(r.K), nameof(r.SpecularReflectance), nameof(r.Alpha));
                return new Ggx(Texture(r.Alpha, isNumber: true), Reflectance(r));
            case PhongMaterialDescription p:
                refusals.Rest(p, nameof(p.Ambient), nameof(p.Diffuse), nameof(p.Specular), nameof(p.Exponent));
                return new Phong(Texture(p.Diffuse), Texture(p.Specular), p.Exponent, p.Ambient is null ? null : Texture(p.Ambient));
            case PhongMetalMaterialDescription m:
                refusals.Rest(m, nameof(m.Color), nameof(m.Exponent));
                return new Phong(new Solid(Rgb.Black), Texture(m.Color), m.Exponent, null);
            case DiffuseSpecularMaterialDescription s:
                refusals.Rest(s, nameof(s.Diffuse), nameof(s.Specular), nameof(s.R0));
                return new Coated(Material(s.Diffuse), Material(s.Specular), s.R0);
            case LuminaireMaterialDescription l:
                refusals.Rest(l, nameof(l.Color), nameof(l.Multiplier), nameof(l.Exponent), nameof(l.Material));
                return Material(l.Material);
            case OneSidedMaterialDescription o:
                return new Sided(Material(o.Material), null);
            case TwoSidedMaterialDescription t:
                return new Sided(Material(t.Front), t.Back is null ? Material(t.Front) : Material(t.Back));
            case IOwnMaterial own:
                return own.Make(Texture);
            default:
                refusals.Type(description, "material", Known);
                return new Diffuse(new Solid(Rgb.Black));
        }
    }

    private ITexture Read(TextureDescription description, bool isNumber) => description switch
    {
        SolidTextureDescription s => new Solid(s.Color),
        CheckerTextureDescription c => new Checker(Texture(c.Even, isNumber), Texture(c.Odd, isNumber), Pair(c.Scale), Pair(c.Offset)),
        ImageTextureDescription i => Image(i, isNumber),
        _ => (ITexture?)refusals.Type(description, "texture", "solid, checker and image") ?? new Solid(Rgb.Black),
    };

    private ImageMap Image(ImageTextureDescription i, bool isNumber)
    {
        refusals.Rest(i, nameof(i.File), nameof(i.Interpolation), nameof(i.Wrapping), nameof(i.VerticalWrapping), nameof(i.Scale), nameof(i.Offset), nameof(i.Raw));
        Picture picture = i.Picture ?? Picture(i, nameof(i.File), i.File, i.Raw ?? isNumber);
        return new ImageMap(picture, i.Interpolation, (i.Wrapping, i.VerticalWrapping ?? i.Wrapping), Pair(i.Scale), Pair(i.Offset));
    }

    /// <summary>What surrounds a scene; null for darkness.</summary>
    public IEnvironment? Environment(SceneDescription scene) => scene.Environment switch
    {
        null => scene.Background.IsBlack ? null : new EvenEnvironment(scene.Background),
        ConstantEnvironmentDescription c => new EvenEnvironment(c.Radiance),
        ImageEnvironmentDescription { Mapping: Lights.DirectionMapping.Octahedral } i => (IEnvironment?)refusals.Say(i, nameof(i.Mapping), "the textbook edition has no octahedral pictures: it has those by latitude and longitude"),
        ImageEnvironmentDescription i => new ImageEnvironment(i.Picture ?? Picture(i, nameof(i.File), i.File, i.Raw), i.Scale, ShapeReader.Place(i.Transform)),
        _ => (IEnvironment?)refusals.Type(scene.Environment, "environment", "constant and image"),
    };

    private Reflectance Reflectance(MetalDescription metal)
    {
        ITexture factor = Texture(metal.SpecularReflectance);
        if (metal.Eta is { } eta && metal.K is { } k)
        {
            return new(eta, k, factor);
        }

        if (!s_metals.TryGetValue(metal.Metal ?? Metal.None, out (Rgb Eta, Rgb K) named))
        {
            refusals.Say(metal, nameof(metal.Metal), $"the textbook edition knows no {metal.Metal}: it knows {string.Join(", ", s_metals.Keys)}; give \"eta\" and \"k\" of others");
        }

        return new(named.Eta, named.K, factor);
    }

    private Picture Picture(object subject, string property, string path, bool isRaw)
    {
        try
        {
            return loadPicture(path, isRaw);
        }
        catch (PictureException e)
        {
            refusals.Say(subject, property, e.Message);
            return new(1, 1);
        }
    }

    private static (double, double) Pair(Vector2 v) => (v.X, v.Y);
}
