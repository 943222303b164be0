using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Session;

/// <summary>The picture of a document: follows its changes and the user's hand, and has the render loop make what is to be seen.</summary>
public sealed class PictureView : IDisposable
{
    private readonly Lock _lock = new();
    private readonly SceneDocument _document;
    private DocumentPlace? _place;
    private ViewportScene? _shown;
    private ViewSettings _settings = new();
    private Tone? _tone;

    private readonly ViewCamera _camera = new();
    private long _pictures;
    private bool _hidesFresh;

    // The film that the picture goes on with, of which place it is, and which picture that is: 0 before the scene is built.
    private FilmStart? _start;
    private DocumentPlace? _startPlace;
    private long _startPicture;
    private int _round;

    /// <summary>Shows a document.</summary>
    public PictureView(SceneDocument document)
    {
        _document = document;
        Loop = new(Frames);
        Loop.StatusChanged += () => Changed?.Invoke();
        Loop.Failed += _ => LeaveEdition();
        document.Changed += Follow;
        Follow();
    }

    /// <summary>
    /// Raised when what is known about the picture has changed; <see cref="Frames"/> reports changes of the picture itself.
    /// </summary>
    public event Action? Changed;

    /// <summary>Raised when the document's scene is not what a film is of, with a sentence that says so.</summary>
    public event Action<string>? Refused;

    /// <summary>The newest frame of the picture.</summary>
    public FrameBoard Frames { get; } = new();

    /// <summary>Makes it.</summary>
    public RenderLoop Loop { get; }

    /// <summary>The scene that is shown; null where there is none.</summary>
    public ViewportScene? Shown => _lock.Read(() => _shown);

    /// <summary>Returns whether the picture is seen through the scene's own camera, as it is rendered to files.</summary>
    public bool IsSceneCamera => Shown is not { } shown || CameraPose.Of(shown.Camera) == CameraPose.Of(shown.Description.Camera);

    /// <summary>Returns whether nothing is left out of the picture.</summary>
    public bool IsWhole => Shown is not { Good.Hidden.Count: > 0 };

    /// <summary>The user's settings.</summary>
    public ViewSettings Settings => _lock.Read(() => _settings);

    /// <summary>The exposure and tone map that the user chose; null for the scene's.</summary>
    public Tone? GivenTone => _lock.Read(() => _tone);

    /// <summary>By how many stops the screen is brighter than the light, by the user or the picture.</summary>
    public float Stops
    {
        get
        {
            Exposure exposure = Tone.Exposure;
            using FrameLease? frame = exposure.Rule == ExposureRule.Stops ? null : Frames.Borrow();
            return frame is { Info.IsLight: true } ? exposure.StopsFor(frame.Picture) : exposure.Stops;
        }
    }

    /// <summary>The exposure and tone map of the screen. A change needs no rendering.</summary>
    /// <exception cref="SessionException">The exposure is out of range.</exception>
    public Tone Tone
    {
        get => _lock.Read(() => _tone ?? (_shown is { } shown ? Tone.Of(shown.Scene.Render) : Tone.Plain));

        set
        {
            if (!(value.Exposure.Stops is >= -Exposure.Limit and <= Exposure.Limit) || !Enum.IsDefined(value.Exposure.Rule) || !Enum.IsDefined(value.ToneMap))
            {
                throw new SessionException("The exposure must be from -100 to 100 stops, and the tone map an existing one.");
            }

            lock (_lock)
            {
                _tone = value;
            }

            Frames.Refresh();
            Changed?.Invoke();
        }
    }

    /// <summary>The map that is shown.</summary>
    /// <exception cref="SessionException">There is nothing.</exception>
    public ViewportScene RequireShown() => Shown ?? throw new SessionException("There is no scene to look at.", SessionFault.Missing);

    /// <summary>Changes what the user wants.</summary>
    /// <param name="change">Makes the new settings of the present ones.</param>
    /// <param name="restart">True to render the picture from scratch.</param>
    /// <exception cref="SessionException">They cannot be.</exception>
    public void Change(Func<ViewSettings, ViewSettings> change, bool restart = false)
    {
        lock (_lock)
        {
            ViewSettings wanted = change(_settings);
            Check(wanted);
            bool isOther = restart || wanted.Region != _settings.Region || wanted.Edition != _settings.Edition;
            _settings = wanted;
            Show(_document.Content.LastGood, isOther);
        }

        Changed?.Invoke();
    }

    /// <summary>Shows the document, which was just opened, as a film or image of it was rendered, and goes on with the film.</summary>
    /// <param name="start">The film; null for none.</param>
    /// <param name="samples">Samples that each pixel gets; null for as many as the scene says.</param>
    /// <param name="region">The part of the picture; null for all.</param>
    /// <param name="edition">The edition that rendered it; null for the fast one.</param>
    internal void Begin(FilmStart? start, int? samples, Tile? region, string? edition)
    {
        lock (_lock)
        {
            (_start, _startPlace, _startPicture) = (start, _document.Place, 0);
            _settings = _settings with { Samples = samples, Region = region, Mode = RenderMode.Running, Map = ViewMap.Light, Edition = edition };
            if (_place == _startPlace)
            {
                Show(_document.Content.LastGood, restart: true);
            }
        }

        Changed?.Invoke();
    }

    /// <summary>A document was opened that is no film or image: what was wanted of one is not wanted of it.</summary>
    internal void Begin()
    {
        lock (_lock)
        {
            if (_startPlace is not null)
            {
                (_start, _startPlace) = (null, null);
                _settings = _settings with { Samples = null, Region = null };

                // A small scene may have been built, and be shown, already.
                if (_place == _document.Place)
                {
                    Show(_document.Content.LastGood, restart: true);
                }
            }
        }

        Changed?.Invoke();
    }

    /// <summary>The hash of everything that decides the value of a sample.</summary>
    internal static string ContentOf(ViewportScene shown, string folder) =>
        Edition.Content(ContentHash.Of(Rendered(shown), ScenePath(folder), shown.Settings.Region), shown.Settings.Edition);

    private static bool IsOf(FilmHeader header, ViewportScene shown, string folder) =>
        OldFilms.Current(header, Rendered(shown), ScenePath(folder), shown.Settings.Region).Content == ContentOf(shown, folder);

    /// <summary>The description of what is rendered: with the view's camera and samples.</summary>
    internal static SceneDescription Rendered(ViewportScene shown) =>
        shown.Description with { Camera = shown.Camera, Render = shown.Scene.Render };

    private static string ScenePath(string folder) => Path.Combine(folder, "scene.json");

    /// <summary>Looks through a camera of the user's, which the text does not have.</summary>
    /// <param name="pose">Its pose; null for the scene's camera.</param>
    /// <returns>True if the scene can be seen from there; if not, nothing has changed.</returns>
    /// <exception cref="SessionException">What was seen is no longer open, and the new scene is still being read.</exception>
    internal bool TryLookFrom(CameraPose? pose)
    {
        lock (_lock)
        {
            GoodScene good = _document.Content.LastGood ?? throw new SessionException("The scene is still being read.", SessionFault.Missing);
            CameraDescription scenes = good.Read.Description!.Camera;
            CameraPose? before = _camera.Own;
            _camera.Set(pose, scenes);
            if (!Show(good, restart: false))
            {
                _camera.Set(before, scenes);
                return false;
            }
        }

        Changed?.Invoke();
        return true;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _document.Changed -= Follow;
        Loop.Dispose();
    }

    /// <summary>Shows nothing until something is opened or changed: a page that offers the gallery hides the first scene.</summary>
    public void HideFresh()
    {
        lock (_lock)
        {
            _hidesFresh = true;
            if (_shown is { Good.Revision: 1 })
            {
                _shown = null;
                Loop.Show(null);
            }
        }
    }

    private void Check(ViewSettings settings)
    {
        if (settings.Threads is < 1 or > 1024)
        {
            throw new SessionException("The number of threads must be from 1 to 1024.");
        }

        if (settings.Samples is < 1 or > 1 << 24)
        {
            throw new SessionException("The number of samples must be from 1 to 16777216.");
        }

        if (settings.Edition is not null && (!Edition.Words.Contains(settings.Edition) || settings.Map == ViewMap.Denoised))
        {
            throw new SessionException(settings.Map == ViewMap.Denoised
                ? "The textbook edition has no denoiser: show the light, or choose the fast edition." : $"There is no edition \"{settings.Edition}\".");
        }

        if (_shown is not { } shown)
        {
            return;
        }

        if (settings.Samples is { } samples && shown.Scene.Render.Sampler.Complaint(samples) is { } complaint)
        {
            throw new SessionException($"{char.ToUpperInvariant(complaint[0])}{complaint[1..]}.");
        }

        if (settings.Region is { } r && !IsWithin(r, shown.Scene.Render))
        {
            throw new SessionException($"The region must lie within the picture of {shown.Scene.Render.Width}×{shown.Scene.Render.Height} pixels.");
        }
    }

    private static bool IsWithin(Tile region, RenderDescription render) =>
        region.X >= 0 && region.Y >= 0 && region.Width >= 1 && region.Height >= 1
        && region.X <= render.Width - region.Width && region.Y <= render.Height - region.Height;

    // What the textbook edition cannot render, the fast one can.
    private void LeaveEdition()
    {
        if (Settings.Edition is not null)
        {
            Change(s => s with { Edition = null });
        }
    }

    // The document has changed, or has been built.
    private void Follow()
    {
        lock (_lock)
        {
            DocumentContent content = _document.Content;
            if (content.LastGood is { } good)
            {
                if (_place != _document.Place || _shown is null)
                {
                    (_place, _tone) = (_document.Place, null);
                    _camera.Set(null, good.Read.Description!.Camera);
                }

                Show(good, restart: false);
            }
            else
            {
                // Of another document nothing is shown any more, and a user who has stopped one picture wants to see the next one.
                _settings = _settings.Mode == RenderMode.Stopped && _shown is not null ? _settings with { Mode = RenderMode.Running } : _settings;
                _shown = null;
                Loop.Show(null);
            }
        }

        Changed?.Invoke();
    }

    // Has the loop render what is to be seen now; false where it cannot be.
    private bool Show(GoodScene? good, bool restart)
    {
        if (good is null || (_hidesFresh && good.Revision == 1) || Seen(good) is not { } shown)
        {
            return false;
        }

        if (_settings.Region is { } region && !IsWithin(region, shown.Scene.Render))
        {
            _settings = _settings with { Region = null };
        }

        if (restart || _shown is null || !IsSamePicture(_shown, shown))
        {
            // A user who has stopped one picture wants to see the next one.
            _settings = _settings.Mode == RenderMode.Stopped && !restart && _shown is not null ? _settings with { Mode = RenderMode.Running } : _settings;
            _pictures++;
            _round += restart ? 1 : 0;
        }

        _shown = WithStart(shown with { Settings = _settings });
        Loop.Show(_shown);
        return true;
    }

    // The scene with the film that the picture goes on with, if it is of this picture.
    private ViewportScene WithStart(ViewportScene shown)
    {
        if (_start is { } start && _startPicture == 0 && _startPlace is { } place && _place == place)
        {
            bool isSame = (start.Header.Width, start.Header.Height) == (shown.Scene.Render.Width, shown.Scene.Render.Height)
                && IsOf(start.Header, shown, place.Folder);
            _startPicture = ++_pictures;
            _start = isSame ? start : null;
            if (!isSame)
            {
                Refused?.Invoke($"The film is not of {place.Name}: the scene, a file that it refers to, its settings, a plug-in or the program have changed. Rendering starts from scratch.");
            }
        }

        return shown with { Place = _place, Picture = _pictures, Round = _round, Start = _startPicture == _pictures ? _start : null };
    }

    private ViewportScene? Seen(GoodScene good)
    {
        SceneDescription description = good.Description;
        CameraDescription camera = _camera.Of(description.Camera);
        RenderDescription render = description.Render;
        if (_settings.Samples is { } samples && render.Sampler.Complaint(samples) is null)
        {
            render = render with { SamplesPerPixel = samples };
        }

        Scene? scene = ReferenceEquals(camera, description.Camera) && ReferenceEquals(render, description.Render)
            ? good.Scene
            : good.Scene.WithView(camera, render, new((_, _) => new(1, 1)));
        return scene is null ? null : new(good, scene, camera, _settings);
    }

    /// <summary>Returns whether the samples of one are samples of the other.</summary>
    internal static bool IsSamePicture(ViewportScene a, ViewportScene b)
    {
        RenderDescription render = a.Scene.Render;

        RenderDescription wanted = render.Sampler.DependsOnCount ? b.Scene.Render : b.Scene.Render with { SamplesPerPixel = render.SamplesPerPixel };
        return DescriptionEquality.Same(render, wanted) && DescriptionEquality.Same(a.Camera, b.Camera)
            && (ReferenceEquals(a.Good, b.Good) || DescriptionEquality.SameThings(a.Description, b.Description));
    }
}
