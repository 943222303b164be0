using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Session;

/// <summary>The picture of a document: follows its changes and the user's hand, and has the render loop make what is to be seen.</summary>
public sealed class PictureView : IDisposable
{
    private readonly Lock _lock = new();
    private readonly SceneDocument _document;
    private DocumentPlace? _place;
    private ShownScene? _shown;
    private ViewSettings _settings = new();
    private Tone _tone = Tone.Plain;

    // The camera in the user's hand, and the revision whose text has it.
    private CameraDescription? _hand;
    private int _handUntil;
    private long _pictures;

    /// <summary>Shows a document.</summary>
    public PictureView(SceneDocument document)
    {
        _document = document;
        Loop = new(Frames);
        Loop.StatusChanged += () => Changed?.Invoke();
        document.Changed += Follow;
        Follow();
    }

    /// <summary>What is known about the picture has changed; the picture itself tells its changes by <see cref="Frames"/>.</summary>
    public event Action? Changed;

    /// <summary>Where the picture is to be seen.</summary>
    public FrameBoard Frames { get; } = new();

    /// <summary>Makes it.</summary>
    public RenderLoop Loop { get; }

    /// <summary>What is shown; null where there is nothing.</summary>
    public ShownScene? Shown
    {
        get
        {
            lock (_lock)
            {
                return _shown;
            }
        }
    }

    /// <summary>The camera that the document had when it was opened; null where there is nothing to be seen.</summary>
    public CameraDescription? Home { get; private set; }

    /// <summary>What the user wants.</summary>
    public ViewSettings Settings
    {
        get
        {
            lock (_lock)
            {
                return _settings;
            }
        }
    }

    /// <summary>How light is brought onto the screen. A change takes no rendering.</summary>
    /// <exception cref="SessionException">The exposure is out of range.</exception>
    public Tone Tone
    {
        get
        {
            lock (_lock)
            {
                return _tone;
            }
        }

        set
        {
            if (!(value.Exposure is >= -100 and <= 100) || !Enum.IsDefined(value.ToneMap))
            {
                throw new SessionException("The exposure must be from -100 to 100 stops, and the tone map one that there is.");
            }

            lock (_lock)
            {
                _tone = value;
            }

            Frames.SeeAnew();
            Changed?.Invoke();
        }
    }

    /// <summary>What is shown.</summary>
    /// <exception cref="SessionException">There is nothing.</exception>
    public ShownScene RequireShown() => Shown ?? throw new SessionException("There is no scene to look at.", SessionFault.Missing);

    /// <summary>Changes what the user wants.</summary>
    /// <param name="change">Makes the new settings of the present ones.</param>
    /// <param name="anew">Whether the picture begins anew.</param>
    /// <exception cref="SessionException">They cannot be.</exception>
    public void Change(Func<ViewSettings, ViewSettings> change, bool anew = false)
    {
        lock (_lock)
        {
            ViewSettings wanted = change(_settings);
            Check(wanted);
            bool isOther = anew || wanted.Region != _settings.Region;
            _settings = wanted;
            Show(isOther);
        }

        Changed?.Invoke();
    }

    /// <summary>Shows another camera, which the text does not have yet.</summary>
    /// <returns>Whether the scene can be seen from there; if not, nothing has changed.</returns>
    internal bool Take(CameraDescription camera)
    {
        lock (_lock)
        {
            CameraDescription? before = _hand;
            (_hand, _handUntil) = (camera, int.MaxValue);
            if (Show(anew: false))
            {
                return true;
            }

            _hand = before;
            return false;
        }
    }

    /// <summary>The camera in the user's hand goes into the text: the text counts again from a revision on.</summary>
    internal void Release(int revision)
    {
        lock (_lock)
        {
            _handUntil = revision;
        }

        Follow();
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _document.Changed -= Follow;
        Loop.Dispose();
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

        if (_shown is not { } shown)
        {
            return;
        }

        if (settings.Samples is { } samples && Sampler.Complaint(shown.Scene.Render.Sampler, samples) is { } complaint)
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
                    (_place, Home, _hand) = (_document.Place, good.Read.Description!.Camera, null);
                }

                _hand = good.Revision >= _handUntil ? null : _hand;
                Show(anew: false);
            }
            else if (content.Revision == _document.Revision)
            {
                _shown = null;
                Loop.Show(null);
            }
        }

        Changed?.Invoke();
    }

    // Has the loop render what is to be seen now; false where it cannot be.
    private bool Show(bool anew)
    {
        if (_document.Content.LastGood is not { } good || Seen(good) is not { } shown)
        {
            return false;
        }

        if (_settings.Region is { } region && !IsWithin(region, shown.Scene.Render))
        {
            _settings = _settings with { Region = null };
        }

        if (anew || _shown is null || !IsSamePicture(_shown, shown))
        {
            // Whoever has stopped one picture wants to see the next one.
            _settings = _settings.Mode == RenderMode.Stopped && !anew && _shown is not null ? _settings with { Mode = RenderMode.Running } : _settings;
            _pictures++;
        }

        _shown = shown with { Picture = _pictures };
        Loop.Show(new()
        {
            Scene = shown.Scene,
            Camera = shown.Camera,
            Picture = _pictures,
            Region = _settings.Region,
            Threads = _settings.Threads,
            Map = _settings.Map,
            Mode = _settings.Mode,
        });
        return true;
    }

    private ShownScene? Seen(GoodScene good)
    {
        SceneDescription description = good.Read.Description!;
        CameraDescription camera = _hand ?? description.Camera;
        RenderDescription render = description.Render;
        if (_settings.Samples is { } samples && Sampler.Complaint(render.Sampler, samples) is null)
        {
            render = render with { SamplesPerPixel = samples };
        }

        Scene? scene = ReferenceEquals(camera, description.Camera) && ReferenceEquals(render, description.Render)
            ? good.Scene
            : good.Scene.WithView(camera, render, new((_, _) => new(1, 1)));
        return scene is null ? null : new(good, scene, camera, 0);
    }

    private static bool IsSamePicture(ShownScene a, ShownScene b)
    {
        RenderDescription render = a.Scene.Render;

        // These samplers' first points do not depend on how many follow.
        bool mayGrow = render.Sampler is SamplerKind.Sobol or SamplerKind.Independent;
        RenderDescription wanted = mayGrow ? b.Scene.Render with { SamplesPerPixel = render.SamplesPerPixel } : b.Scene.Render;
        return DescriptionEquality.Same(render, wanted) && DescriptionEquality.Same(a.Camera, b.Camera)
            && (ReferenceEquals(a.Good, b.Good) || DescriptionEquality.SameThings(a.Description, b.Description));
    }
}
