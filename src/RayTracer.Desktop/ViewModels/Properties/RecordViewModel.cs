using System.Text.Json.Nodes;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>An editor for each parameter of a record, in the schema's order.</summary>
/// <param name="context">The rest of the window, as editors use it.</param>
/// <param name="type">The record's type.</param>
/// <param name="pointer">The pointer to it.</param>
/// <param name="without">Parameters that are shown elsewhere.</param>
internal sealed class RecordViewModel(PanelContext context, CatalogueType type, string pointer, params string[] without)
{
    /// <summary>The record's type.</summary>
    public CatalogueType Type => type;

    public string Summary => Type.Summary;

    /// <summary>The editors.</summary>
    public IReadOnlyList<FieldViewModel> Fields { get; } =
        [.. type.Parameters.Where(p => !without.Contains(p.Key)).Select(p => FieldViewModel.Of(context, p, JsonPointer.Append(pointer, p.Key)))];

    /// <summary>Shows what is written.</summary>
    public void Show(JsonNode? value)
    {
        foreach (FieldViewModel field in Fields)
        {
            field.Show((value as JsonObject)?[field.Parameter.Key]);
        }
    }
}

/// <summary>A record within a record, such as the lens of a camera.</summary>
internal sealed class RecordFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer, CatalogueType type)
    : FieldViewModel(context, parameter, pointer)
{
    /// <summary>Its parameters.</summary>
    public RecordViewModel Record { get; } = new(context, type, pointer);

    /// <inheritdoc/>
    protected override void Shown() => Record.Show(Written);
}

/// <summary>A list of records, such as the steps of a transform.</summary>
internal sealed class StepsFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer, CatalogueType type)
    : FieldViewModel(context, parameter, pointer)
{
    /// <summary>The records.</summary>
    public IReadOnlyList<StepViewModel> Steps { get; private set; } = [];

    public string AddText => SessionTexts.Of("panel.addStep", Label);

    /// <summary>Adds one.</summary>
    public ICommand Add => new RelayCommand(() =>
    {
        JsonArray list = [.. (Written as JsonArray ?? []).Select(s => s?.DeepClone()), ParameterValues.Fresh(type)];
        Write(list);
    });

    /// <inheritdoc/>
    protected override void Shown()
    {
        JsonArray written = Written as JsonArray ?? [];
        if (written.Count != Steps.Count)
        {
            Steps = [.. written.Select((_, i) => Step(i))];
        }

        for (int i = 0; i < Steps.Count; i++)
        {
            Steps[i].Record.Show(written[i]);
        }
    }

    private StepViewModel Step(int i)
    {
        string at = JsonPointer.Append(Pointer, i);
        return new(
            SessionTexts.Of("panel.step", i + 1), SessionTexts.Of("panel.removeStep", i + 1), new RecordViewModel(Context, type, at), new RelayCommand(() => Context.Delete(at)));
    }
}

/// <summary>A record of a list, such as a step of a transform.</summary>
/// <param name="Title">The title.</param>
/// <param name="RemoveText">The label of the button that takes it away.</param>
/// <param name="Record">Its parameters.</param>
/// <param name="Remove">Takes it away.</param>
internal sealed record StepViewModel(string Title, string RemoveText, RecordViewModel Record, ICommand Remove);
