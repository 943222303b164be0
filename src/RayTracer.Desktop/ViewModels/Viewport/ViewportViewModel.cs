using System.Globalization;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The picture, always its newest frame, and what is done with it.</summary>
internal sealed partial class ViewportViewModel(SessionDispatcher dispatcher) : Observable
{
    private static readonly double[] Percents = [12.5, 25, 50, 100, 200, 400, 800, 1600];
    private readonly Latest<Tone> _toning = new(tone => dispatcher.Attempt(() => dispatcher.Ask(s => s.View.Tone = tone)));
    private readonly byte[][] _buffers = [[], []];
    private SessionState? _state;
    private Tone _tone = Tone.Plain;
    private IReadOnlyList<Choice> _zooms = [];

    /// <summary>Moves the camera.</summary>
    public CameraDrive Camera { get; } = new(dispatcher);

    /// <summary>The handles of the selected shape.</summary>
    public GizmoViewModel Gizmo { get; } = new(dispatcher);

    /// <summary>The newest frame; null before there was one.</summary>
    public PixelFrame? Frame { get; private set => SetProperty(ref field, value); }

    /// <summary>Returns whether the frame is coarser than the picture.</summary>
    public bool IsPreview { get; private set => SetProperty(ref field, value); }

    public Stage Stage
    {
        get;
        private set
        {
            if (SetProperty(ref field, value))
            {
                Gizmo.Place(value);
                OnPropertyChanged("");
            }
        }
    } = Stage.Empty;

    /// <summary>The picture's place on the screen.</summary>
    public Box Place => Stage.Place;

    /// <summary>The number of the screen's pixels for one of the window's.</summary>
    public double ScreenScale { get; set; } = 1;

    public Tool Tool
    {
        get;
        set
        {
            if (SetProperty(ref field, value))
            {
                _ = FollowHandles();
                OnPropertyChanged(nameof(Mark));
            }
        }
    }

    /// <summary>Exposure in stops.</summary>
    public double Exposure
    {
        get => _tone.Exposure.Rule == ExposureRule.Stops ? _tone.Exposure.Stops : _state?.Stops ?? 0;
        set => SetTone(_tone with { Exposure = (float)Math.Round(Math.Clamp(value, -20, 20), 3) });
    }

    /// <summary>Exposure as it is typed.</summary>
    public string ExposureText
    {
        get => Figures.Short(Exposure);
        set
        {
            Exposure = Figures.Parse(value) ?? Exposure;
            OnPropertyChanged();
        }
    }

    /// <summary>Who may decide on the exposure.</summary>
    public IReadOnlyList<Choice> ExposureRules { get; } =
        [.. Enum.GetValues<ExposureRule>().Select(r => new Choice(r.ToString(), SessionTexts.Of($"viewport.exposureRules.{r.ToString().ToLowerInvariant()}")))];

    /// <summary>Who decides on the exposure.</summary>
    public Choice? Rule
    {
        get => ExposureRules.First(r => r.Value == _tone.Exposure.Rule.ToString());
        set
        {
            if (!IsReporting && value is not null)
            {
                ExposureRule rule = Enum.Parse<ExposureRule>(value.Value);
                SetTone(_tone with { Exposure = new(rule == ExposureRule.Stops ? (float)Exposure : 0, rule) });
            }
        }
    }

    /// <summary>The tone maps.</summary>
    public IReadOnlyList<Choice> ToneMaps { get; } = [.. Enum.GetValues<ToneMap>().Select(t => new Choice(t.ToString(), Figures.Spaced(char.ToLowerInvariant(t.ToString()[0]) + t.ToString()[1..])))];

    /// <summary>The tone map.</summary>
    public Choice? ToneMap
    {
        get => ToneMaps.First(t => t.Value == _tone.ToneMap.ToString());
        set
        {
            if (!IsReporting && value is not null)
            {
                SetTone(_tone with { ToneMap = Enum.Parse<ToneMap>(value.Value) });
            }
        }
    }

    /// <summary>The maps to choose from: the light, or what the renderer knows about each pixel.</summary>
    public IReadOnlyList<Choice> Maps { get; } = [.. ViewMap.All.Select(m => new Choice(m.Name, m.Title, m.Why))];

    /// <summary>The map that is shown.</summary>
    public Choice? Map
    {
        get => Maps.First(m => m.Value == (_state?.Settings.Map ?? ViewMap.Light).Name);
        set
        {
            if (!IsReporting && value is not null && value != Map)
            {
                ViewMap map = ViewMap.Named(value.Value);
                dispatcher.Do(s => s.View.Change(v => v with { Map = map }));
            }
        }
    }

    /// <summary>The sizes of a picture's pixel on the screen to choose from.</summary>
    public IReadOnlyList<Choice> Zooms
    {
        get
        {
            string now = Percent(Stage.Scale * ScreenScale * 100);
            string[] known = [.. Percents.Select(Percent)];
            Choice[] zooms = [.. known.Contains(now) ? [] : new[] { new Choice(now, $"{now} %") }, .. known.Select(p => new Choice(p, $"{p} %"))];

            // A list that is the same one stays, so that the view does not start from scratch.
            return _zooms = zooms.SequenceEqual(_zooms) ? _zooms : zooms;
        }
    }

    /// <summary>The size of a picture's pixel on the screen.</summary>
    public Choice? Zoom
    {
        get => Zooms.First(z => z.Value == Percent(Stage.Scale * ScreenScale * 100));
        set
        {
            if (!IsReporting && value is not null && value != Zoom)
            {
                ZoomTo(double.Parse(value.Value, CultureInfo.InvariantCulture) / 100 / ScreenScale);
            }
        }
    }

    /// <summary>Returns whether only a part of the picture is rendered.</summary>
    public bool HasRegion => _state?.Settings.Region is not null;

    /// <summary>Renders the whole picture again.</summary>
    public ICommand ClearRegion => field ??= new RelayCommand(() => dispatcher.Do(s => s.View.Change(v => v with { Region = null })));

    /// <summary>Returns whether the text has an error, and the last good picture is shown.</summary>
    public bool IsLastGood => _state is { Document.IsGood: false } && Frame is not null;

    /// <summary>Shows the whole picture.</summary>
    public void Fit() => Stage = Stage with { Zoom = null, Shift = default };

    /// <summary>One pixel of the picture on one of the screen.</summary>
    public void ActualSize() => ZoomTo(1 / ScreenScale);

    /// <summary>Enlarges the picture.</summary>
    public void ZoomBy(double factor) => Stage = Stage.ZoomedBy(factor);

    /// <summary>The part of the window has another size.</summary>
    public void Resize(double width, double height) => Stage = Stage with { Width = Math.Max(1, width), Height = Math.Max(1, height) };

    /// <summary>Shows a state.</summary>
    public void Show(SessionState state)
    {
        _state = state;
        _tone = state.Tone;
        ShowSnapshots(state.Snapshots);
        _ = FollowSelection(state);
        OnPropertyChanged("");
    }

    /// <summary>Takes frames as they come, until it is stopped. The renderer waits for nobody who looks.</summary>
    public async Task FollowFrames(PictureView view, CancellationToken stop)
    {
        long version = 0;
        for (int i = 0; await view.Frames.Wait(version, stop); i = 1 - i)
        {
            int buffer = i;
            (PixelFrame Frame, FrameInfo Info, long Version)? taken = await Task.Run(() => CopyFrame(view, buffer), stop);
            if (taken is { } newest)
            {
                version = newest.Version;
                Frame = newest.Frame;
                IsPreview = newest.Info.IsPreview;
                Stage = Stage with { PictureWidth = newest.Info.PictureWidth, PictureHeight = newest.Info.PictureHeight };
            }
        }
    }

    // The window shows one buffer while the other one is filled.
    private (PixelFrame Frame, FrameInfo Info, long Version)? CopyFrame(PictureView view, int buffer)
    {
        using FrameLease? lease = view.Frames.Borrow();
        if (lease is null)
        {
            return null;
        }

        Stage stage = Stage;
        int reduction = stage.Zoom is null ? FramePixels.Reduction(lease.Picture, (int)(stage.Width * ScreenScale), (int)(stage.Height * ScreenScale)) : 1;
        (int width, int height) = (lease.Picture.Width / reduction, lease.Picture.Height / reduction);
        Array.Resize(ref _buffers[buffer], 4 * width * height);
        FramePixels.Write(lease.Picture, lease.Info.IsLight ? view.Tone : Tone.Plain, reduction, _buffers[buffer]);
        return (new(width, height, _buffers[buffer]), lease.Info, lease.Version);
    }

    private static string Percent(double percent) =>
        (Math.Abs(percent - 12.5) < 0.01 ? percent : Math.Round(percent)).ToString(CultureInfo.InvariantCulture);

    private void ZoomTo(double scale) => Stage = Stage.ZoomedBy(scale / Stage.Scale);

    private void SetTone(Tone tone)
    {
        if (tone != _tone)
        {
            _tone = tone;
            _toning.Push(tone);
            Report(nameof(Exposure), nameof(ExposureText), nameof(Rule), nameof(ToneMap));
        }
    }
}
