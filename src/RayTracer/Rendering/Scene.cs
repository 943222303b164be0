using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Cameras;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;
using RayTracer.Spectra;
using RayTracer.Textures;

namespace RayTracer.Rendering;

/// <summary>
/// A scene that is ready to be rendered: never changed any more, so any number of threads may read it. Made by <see cref="SceneBuilder"/>.
/// </summary>
public sealed class Scene
{
    // Up to so many lights, each point is lit by a point of every one.
    private const int MostLightsOfPoint = 8;
    private readonly Interior[] _interiors;

    // As the scene has it: another integrator may need the background as one.
    private readonly EnvironmentLight? _given;

    private Scene(RenderDescription render, Camera camera, Rgb background, EnvironmentLight? environment, Rgb ambient, World world)
    {
        Render = render;
        Camera = camera;
        Background = background;
        Ambient = ambient;
        Sampler = render.Sampler.Create(render.SamplesPerPixel);
        Filter = PixelFilter.Create(render.Filter);
        World = world;
        _given = environment;
        Environment = Surroundings();
        Shapes = World.Itself.Shapes;
        Batches = World.Itself.Batches;
        Primitives = World.Itself.Primitives;
        IsTimed = camera.Moves || World.Moves;
        Groups = ShadingGroup.Create(World, out int[] groupOf);
        GroupOfPrimitive = groupOf;
        _interiors = ShadingGroup.NumberInteriors(Groups);
        Wavelengths = Array.Exists(Groups, g => g.Traits.Disperses) ? new() : null;
        Media = new(_interiors);
        GroupOfMedia = new(new MediumMaterial(Media), null, -1, isInstanced: false);
        (HasMedia, HasNesting, WeakensShadows, PassesStraight, IsLiteral) = Shown();
        HidesLights = render.HideLights && render.Integrator.Has(IntegratorTraits.HiddenLights);
        CameraInteriors = TracksInteriors ? EnclosingMedia.Of(this) : 0;
        Lights = LightList.Create(World);
        LightSelection = SelectLights();
        Splitting = CanSplit() ? Splitting.Of(render.Splitting, render.Sampler, Sampler) : null;
        PointsOfFirst = CountPoints();
    }

    // The same things seen in another way.
    private Scene(RenderDescription render, Camera camera, Scene other)
    {
        Render = render;
        Camera = camera;
        Background = other.Background;
        Ambient = other.Ambient;
        Sampler = render.Sampler.Create(render.SamplesPerPixel);
        Filter = PixelFilter.Create(render.Filter);
        World = other.World;
        _given = other._given;
        Environment = Surroundings();
        Shapes = other.Shapes;
        Batches = other.Batches;
        Primitives = other.Primitives;
        IsTimed = camera.Moves || World.Moves;
        Groups = other.Groups;
        GroupOfPrimitive = other.GroupOfPrimitive;
        Wavelengths = other.Wavelengths;
        _interiors = other._interiors;
        Media = other.Media;
        GroupOfMedia = new(new MediumMaterial(Media), null, -1, isInstanced: false);
        (HasMedia, HasNesting, WeakensShadows, PassesStraight, IsLiteral) = Shown();
        HidesLights = render.HideLights && render.Integrator.Has(IntegratorTraits.HiddenLights);
        CameraInteriors = TracksInteriors ? EnclosingMedia.Of(this) : 0;
        Lights = other.Lights;
        LightSelection = render.Integrator == other.Render.Integrator ? other.LightSelection : SelectLights();
        Splitting = CanSplit() ? Splitting.Of(render.Splitting, render.Sampler, Sampler) : null;
        PointsOfFirst = CountPoints();
        MattesAlone = other.MattesAlone is { } alone ? new(render, camera, alone) : null;
    }

    private Scene(Scene other, RenderDescription render, PathGuide? guide)
        : this(render, other.Camera, other) => Guide = guide;

    /// <summary>Size, samples, depths and sampler.</summary>
    public RenderDescription Render { get; }

    /// <summary>The camera.</summary>
    public Camera Camera { get; }

    /// <summary>The source of random numbers.</summary>
    public Sampler Sampler { get; }

    /// <summary>The samples that share a camera ray; null where each has its own.</summary>
    internal Splitting? Splitting { get; }

    /// <summary>Places samples around the middle of their pixel; null for the mean over the pixel's own square.</summary>
    internal PixelFilter? Filter { get; }

    /// <summary>Radiance where nothing is hit, unless there is an <see cref="Environment"/>.</summary>
    public Rgb Background { get; }

    /// <summary>The light that rays see which leave the scene; null where that is the <see cref="Background"/>.</summary>
    public EnvironmentLight? Environment { get; }

    /// <summary>Ambient radiance.</summary>
    public Rgb Ambient { get; }

    /// <summary>The shapes of the world itself by primitive number: those that are neither meshes nor shown by instances.</summary>
    public IReadOnlyList<Shape> Shapes { get; }

    /// <summary>The light sources of the scene.</summary>
    public IReadOnlyList<LightSource> Lights { get; }

    /// <summary>
    /// The sources that the integrator samples for light: those of the scene, and where it traces paths, the environment behind it.
    /// </summary>
    internal IReadOnlyList<LightSource> SampledLights => SampledEnvironment is { } environment ? [.. Lights, environment] : Lights;

    /// <summary>
    /// The environment, where the integrator samples it for light. One of a single colour is found as well by the rays that surfaces scatter, and needs no others; but
    /// paths that come from lights start there.
    /// </summary>
    internal EnvironmentLight? SampledEnvironment => Render.Integrator.Has(IntegratorTraits.SampledEnvironment)
        && (Environment is not ConstantEnvironment || Render.Integrator.Has(IntegratorTraits.TracesLight)) ? Environment : null;

    /// <summary>Those shapes packed by kind.</summary>
    public IReadOnlyList<ShapeBatch> Batches { get; }

    /// <summary>Meets rays with those shapes.</summary>
    internal PrimitiveList Primitives { get; }

    /// <summary>Everything that rays can meet.</summary>
    internal World World { get; }

    /// <summary>Helps to choose the directions of paths; null for none.</summary>
    internal PathGuide? Guide { get; }

    /// <summary>The names of all that it shows.</summary>
    internal MatteNames Names => field ??= new(this);

    /// <summary>True where something stands for a thing of a photograph, which pictures with alpha leave out (<see cref="MatteRole"/>).</summary>
    internal bool HasMattes => Array.Exists(Groups, static g => g.Traits.Matte != MatteRole.None);

    /// <summary>The scene without the things that throw shadows on shadow catchers; null where there are no such catchers.</summary>
    internal Scene? MattesAlone { get; private init; }

    /// <summary>True where anything moves while the shutter is open, so that paths have times.</summary>
    internal bool IsTimed { get; }

    /// <summary>Times of samples while the shutter is open, in seconds; the same for all paths of a sample where paths are merged.</summary>
    internal FloatW Time(in UIntW key, in UIntW sample)
    {
        Sampler.Begin(SharedKey is uint shared ? shared : key, sample, Dimensions.Time, out SamplePoints points);
        Sampler.Pair(points, 0, out FloatW u, out _);
        return FloatW.MultiplyAdd(u, Render.Shutter.Y - Render.Shutter.X, Render.Shutter.X);
    }

    /// <summary>
    /// The key of the random numbers that all paths of a sample share, their time and their wavelength, so that they can be merged; null where each
    /// path has its own.
    /// </summary>
    internal uint? SharedKey => Render.Integrator.Has(IntegratorTraits.MergesPaths) ? Hash.PixelKey((uint)Render.Seed, uint.MaxValue) : null;

    /// <summary>
    /// Chooses one light for each point; null where all of them are sampled at each: in the report, and where they are few.
    /// </summary>
    internal LightSelection? LightSelection { get; }

    /// <summary>
    /// The number of points of each light, or of lights that are chosen, where paths first meet the scene: most of the noise comes from there, and a shadow ray is
    /// less work than a path (decision 019).
    /// </summary>
    internal int PointsOfFirst { get; }

    /// <summary>Gives paths wavelengths; null where no surface disperses light.</summary>
    internal Wavelengths? Wavelengths { get; }

    /// <summary>The media that fill shapes.</summary>
    internal MediumTable Media { get; }

    /// <summary>The points at which media scatter light, for subpaths: they are shaded as if they were a surface.</summary>
    internal ShadingGroup GroupOfMedia { get; }

    /// <summary>True where media absorb and scatter light: there are some, and the integrator is one that shows them.</summary>
    internal bool HasMedia { get; }

    /// <summary>True where some of them vary, and the integrator is one that follows those.</summary>
    internal bool HasVaryingMedia => HasMedia && Media.Varying.Length > 0 && Render.Integrator.Has(IntegratorTraits.VaryingMedia);

    /// <summary>True where dielectrics have priorities: there are some, and the integrator is one that knows them.</summary>
    internal bool HasNesting { get; }

    /// <summary>True where what goes straight through a surface has no vertex there: some surface lets light through so, and the scene asks for it.</summary>
    internal bool PassesStraight { get; }

    /// <summary>True where rays of the camera pass what shines, and see nothing behind everything.</summary>
    internal bool HidesLights { get; }

    /// <summary>True where paths may go through surfaces that are no bounce, and count them (<see cref="PathState.OnePassed"/>).</summary>
    internal bool CountsPassed => PassesStraight || HidesLights;

    /// <summary>True where paths keep a record of the media that they are in, and of how far they have come since they last scattered.</summary>
    internal bool TracksInteriors => HasMedia || HasNesting || PassesStraight;

    /// <summary>True where paths have no vertex on surfaces of invisible materials (<see cref="Materials.MaterialTraits.IsBoundary"/>).</summary>
    internal bool CrossesBoundaries => HasMedia || PassesStraight;

    /// <summary>The media that the camera stands in.</summary>
    internal uint CameraInteriors { get; }

    /// <summary>True where transparent things only weaken the light of sources behind them.</summary>
    internal bool WeakensShadows { get; }

    /// <summary>Returns the media that a path is in after a boundary.</summary>
    /// <param name="stack">The media that it is in.</param>
    /// <param name="interior">Number of what is inside the boundary.</param>
    /// <param name="crosses">The lanes in which the boundary is crossed.</param>
    /// <param name="enters">True if that is inwards.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal UIntW Cross(UIntW stack, uint interior, MaskW crosses, MaskW enters)
    {
        Cross(stack, interior, crosses, enters, out UIntW crossed);
        return crossed;
    }

    // No register is passed by value, which code that is compiled ahead cannot do.
    private unsafe void Cross(in UIntW stack, uint interior, in MaskW crosses, in MaskW enters, out UIntW crossed) => crossed = HasNesting
        ? MediumStack.CrossByPriority(stack, interior, crosses, enters, Media.Priorities)
        : MediumStack.Cross(stack, interior, crosses, enters);

    /// <summary>True where shading normals alone decide from which side surfaces are seen.</summary>
    internal bool IsLiteral { get; }

    /// <summary>The groups of surfaces that are shaded together.</summary>
    internal ShadingGroup[] Groups { get; }

    /// <summary>
    /// The group of each primitive, and, further on, what stands for rays that hit nothing and for those that a medium scatters.
    /// </summary>
    internal int[] GroupOfPrimitive { get; }

    /// <summary>Makes the scene that a description describes.</summary>
    /// <param name="description">The scene.</param>
    /// <param name="loadPicture">As for <see cref="SceneBuilder"/>.</param>
    /// <param name="loadModel">As for <see cref="SceneBuilder"/>.</param>
    /// <param name="loadGrid">As for <see cref="SceneBuilder"/>.</param>
    /// <exception cref="SceneException">Something is wrong with it: the message says all of it.</exception>
    public static Scene From(SceneDescription description, Func<string, bool, Picture>? loadPicture = null, Func<string, ImportedModel>? loadModel = null, Func<GridDescription, VolumeGrid>? loadGrid = null)
    {
        SceneBuilder builder = new(loadPicture, loadModel, loadGrid);
        return builder.Build(description) ?? throw new SceneException(builder.Complaints);
    }

    /// <summary>
    /// Everything that can be seen, one by one; what instances show, once for each of them, where it stands when the shutter opens.
    /// </summary>
    public IEnumerable<PlacedSurface> Surfaces() => PlacedSurface.All(World);

    /// <summary>
    /// What a primitive was made from: of what an instance shows, the instance, or else the shape, mesh or model; null where the scene was
    /// built without <see cref="SceneBuilder.KeepsSources"/>.
    /// </summary>
    /// <param name="primitive">The primitive's number.</param>
    /// <param name="instance">The instance that shows it; 0 for the world itself.</param>
    public ShapeDescription? SourceOf(int primitive, int instance) =>
        instance > 0 ? World.Instances!.SourceOf(instance) : World.Itself.SourceOf(primitive);

    /// <summary>What a light that paths ask was made from; null for the surroundings, and as for <see cref="SourceOf"/>.</summary>
    /// <param name="light">The light's number, from 0.</param>
    public ShapeDescription? SourceOfLight(int light)
    {
        LightSource source = SampledLights[light];
        int punctual = light - (Lights.Count - World.Itself.Contents.Lights.Count);
        return source is MeshLight mesh ? SourceOf(mesh.FirstPrimitive, mesh.Instance)
            : source.Primitive >= 0 ? SourceOf(source.Primitive, source.Instance)
            : source != SampledEnvironment && punctual >= 0 ? World.Itself.Contents.Lights[punctual].Light : null;
    }

    /// <summary>Returns the description that the material of a primitive was made from; null as for <see cref="SourceOf"/>.</summary>
    public MaterialDescription? MaterialSourceOf(int primitive) => Groups[GroupOfPrimitive[primitive]].Material.Source;

    /// <summary>
    /// The same things seen by another camera, or rendered in another way; reports what is wrong and returns null. Takes no time.
    /// </summary>
    /// <param name="camera">The camera.</param>
    /// <param name="render">The settings of the rendering. Its shutter and its sampling of spheres have no effect: they are built in.</param>
    /// <param name="builder">Takes the diagnostics.</param>
    public Scene? WithView(CameraDescription camera, RenderDescription render, SceneBuilder builder) =>
        View(camera, render with { Shutter = Render.Shutter, SphereLightSampling = Render.SphereLightSampling }, builder) is var (checkedRender, made)
            ? new Scene(checkedRender, made, this)
            : null;

    /// <summary>The same scene with another guide, or rendered in another way, by the same camera.</summary>
    internal Scene Guided(PathGuide? guide, RenderDescription? render = null) => new(this, render ?? Render, guide);

    // Paths that come from the lights alone never get to what is behind everything: it has to be one of the lights.
    private EnvironmentLight? Surroundings()
    {
        EnvironmentLight? around = _given ?? (Render.Integrator == Integrator.Light && !Background.IsBlack ? new ConstantEnvironment(Background) { Label = new(null, "background") } : null);
        around?.World = World;
        return around;
    }

    /// <summary>Makes a scene from built shapes; reports what is wrong and returns null.</summary>
    internal static Scene? Create(SceneDescription description, SpaceContents contents, SceneBuilder builder)
    {
        if (View(description.Camera, description.Render, builder) is not var (render, camera))
        {
            return null;
        }

        Scene Of(SpaceContents things, Scene? alone) => new(
            render, camera, description.Background, builder.Environment(description), description.Ambient, new(things, (render.Shutter.X, render.Shutter.Y), builder.LargestLoop))
        {
            MattesAlone = alone,
        };
        bool catches = contents.Has(m => m.Traits.Matte == MatteRole.ShadowCatcher);
        Scene scene = Of(contents, catches ? Of(contents.Only(m => m.Traits.Emits || m.Traits.Matte != MatteRole.None), null) : null);
        if (scene._interiors.Length > MediumStack.MaxMedia)
        {
            builder.Error(description, nameof(SceneDescription.Materials), $"the materials have {scene._interiors.Length} different insides (media, and dielectrics with a priority), but at most {MediumStack.MaxMedia} are possible");
            return null;
        }

        new UnseenParts(scene, description, builder).WarnOfIntegrator();
        return scene;
    }

    // What the scene asks for and its integrator can do.
    private (bool Media, bool Nesting, bool WeakenedShadows, bool StraightThrough, bool LiteralNormals) Shown() => (
        Render.Integrator.Has(IntegratorTraits.Media) && HasInterior(static i => i.Medium is not null),
        Render.Integrator.Has(IntegratorTraits.Priorities) && HasInterior(static i => i.Nesting is not null),
        Render.Integrator.Has(IntegratorTraits.WeakenedShadows) && Render.WeakenedShadows,
        Render.Integrator.Has(IntegratorTraits.StraightThrough) && Render.StraightThrough && Array.Exists(Groups, static g => g.Traits.PassesStraight),
        Render.Integrator.Has(IntegratorTraits.LiteralNormals) && Render.ShadingNormals == ShadingNormals.Literal);

    // Not where much of the noise comes from the camera's ray itself (lenses, motion, the fine shapes of meshes), from the choice of lights, or from all that
    // there is (direct light alone); nor where something happens to the ray on its way, or paths differ from the start.
    private bool CanSplit() => Render.Integrator.Has(IntegratorTraits.Splits) && World.IsPlain && !Camera.HasLens && !IsTimed
        && SampledEnvironment is null && LightSelection is null && !TracksInteriors && !HidesLights && Wavelengths is null
        && (Render.Integrator.Has(IntegratorTraits.BounceLimits) ? Render.MaxDiffuseDepth > 0 : Render.MaxDepth is < 0 or > 2);

    private bool HasInterior(Predicate<Interior> which) => Array.Exists(_interiors, which);

    private LightSelection? SelectLights() => SampledLights.Count > MostLightsOfPoint && Render.Integrator.Has(IntegratorTraits.SampledEnvironment)
        ? new(SampledLights, (Render.Shutter.X, Render.Shutter.Y))
        : null;

    private int CountPoints() => TracksInteriors || HidesLights || Splitting is not null || !Render.Integrator.Has(IntegratorTraits.SampledEnvironment) ? 1
        : LightSelection is not null ? 4
        : SampledLights.Any(l => !l.IsDelta) ? 2 : 1;

    // Checks how a scene is to be seen.
    private static (RenderDescription Render, Camera Camera)? View(CameraDescription camera, RenderDescription render, SceneBuilder builder)
    {
        if (!(builder.IsInRange(camera) & builder.IsInRange(render)))
        {
            return null;
        }

        if (render.Sampler.Complaint(render.SamplesPerPixel) is { } complaint)
        {
            builder.Error(render, nameof(RenderDescription.SamplesPerPixel), complaint);
        }

        if (!(render.Shutter.Y >= render.Shutter.X) || !float.IsFinite(render.Shutter.Y - render.Shutter.X))
        {
            builder.Error(render, nameof(RenderDescription.Shutter), $"the shutter must not close before it opens, but it opens at {render.Shutter.X} and closes at {render.Shutter.Y}");
        }

        if (FilterCurve.Fault(render.Filter) is var (property, fault))
        {
            builder.Error(render.Filter, property, fault);
        }

        if (camera.Lens is { Shape: not LensShape.EyeJitter, ApertureRadius: 0, FocusDistance: > 0 })
        {
            builder.Warn(camera.Lens, nameof(LensDescription.FocusDistance), "without an \"apertureRadius\" the lens is a pinhole, and \"focusDistance\" has no effect");
        }

        Camera? made = Camera.Create(camera, render.Width, render.Height, builder, PixelFilter.Margin(render.Filter));
        return made is null || builder.HasErrors ? null : (render, made);
    }
}
