-- | The report of @blackhole photon@ on one light path: a table, JSON and CSV.
module BlackHole.Cli.Photon.Report
  ( PhotonOutcome (..),
    photonOutcome,
    outcomeText,
    outcomePoints,
    outcomeCsv,
  )
where

import BlackHole.Cli.Json
import BlackHole.Cli.Photon.Options
import BlackHole.Cli.TextTable
import BlackHole.Matter.KerrReport
import BlackHole.Matter.PathReport
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Follow (Method (ByTable, InClosedForm))
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isUpper, toLower)
import Data.List (intercalate, isSuffixOf, stripPrefix)
import Data.Maybe (fromMaybe)

-- | The reports on a path.
data PhotonOutcome
  = -- | That of the closed form alone.
    ExactOutcome !PathReport
  | -- | That of another method, whose name comes first, and that of the closed form.
    ComparedOutcome !String !PathReport !PathReport
  | -- | That of the closed form around a rotating hole.
    RotatingOutcome !KerrReport
  | -- | That of the renderer's table around a rotating hole, and that of the closed form.
    ComparedRotating !KerrReport !KerrReport
  deriving (Eq, Show)

-- | Follow the light. The path's points extend to 100 Schwarzschild radii, to the
-- camera, or to four times the impact parameter, whichever is farthest.
photonOutcome :: PhotonTask -> PhotonOutcome
photonOutcome (RotatingTask method hole azimuth ray) = case method of
  ByTable -> ComparedRotating (report ByTable) (report InClosedForm)
  _ -> RotatingOutcome (report method)
  where
    report way = kerrReport way hole 100 azimuth ray
photonOutcome (PhotonTask trajectory method) = case method of
  ClosedForm -> ExactOutcome exact
  Leapfrog rule -> ComparedOutcome "leapfrog" (leapfrogReport rule drawn trajectory) exact
  FromTable tabulated -> ComparedOutcome "table" (exactReport drawn tabulated) exact
  where
    exact = exactReport drawn trajectory
    drawn = max 100 (4 * trajectoryImpactParameter trajectory)

-- | The outcome as JSON or, with 'False', as a table with units.
outcomeText :: Bool -> PhotonOutcome -> String
outcomeText json outcome
  | json = renderJson . Object $ case outcome of
    ExactOutcome report -> reportMembers report
    ComparedOutcome _ report exact ->
      reportMembers report
        ++ [ ("exact", Object (reportMembers exact)),
             ("error", Object (differenceMembers (reportDifference report exact)))
           ]
    RotatingOutcome report -> rotatingMembers report
    ComparedRotating report exact ->
      rotatingMembers report
        ++ [ ("exact", Object (rotatingMembers exact)),
             ("error", Object (rotatingDifference report exact))
           ]
  | otherwise = case outcome of
    ExactOutcome report ->
      table [[name, content, unitOf name] | (name, content) <- rows report]
        ++ legend report
    ComparedOutcome name report exact ->
      compared
        name
        (reportMembers report)
        (reportMembers exact)
        (differenceMembers (reportDifference report exact))
        ++ legend report
    RotatingOutcome report ->
      table [[name, content, unitOf name] | (name, content) <- flatten (rotatingMembers report)]
        ++ rotatingLegend report
    ComparedRotating report exact ->
      compared
        "table"
        (rotatingMembers report)
        (rotatingMembers exact)
        (rotatingDifference report exact)
        ++ rotatingLegend report
  where
    rows = flatten . reportMembers
    rotatingLegend report =
      unlines ["", "r_s is the Schwarzschild radius 2GM/c^2."]
        ++ legendOf (not (null (kerrReportCrossings report)))
    compared name own exact errors =
      table
        ( ["", name, "exact", "error", ""] :
          besides (flatten own) (flatten exact) (flatten errors)
        )
    besides own exact errors =
      [ [name, cell name own, cell name exact, cell name errors, unitOf name]
        | name <- map fst own ++ filter (`notElem` map fst own) (map fst exact)
      ]
    cell name = fromMaybe "-" . lookup name
    table cells = unlines (tableLines (repeat LeftAligned) (map Cells cells))
    legend report =
      unlines
        [ "",
          "r_s is the Schwarzschild radius 2GM/c^2. A drift is relative to the value at the start."
        ]
        ++ legendOf (not (null (reportCrossings report)))
    legendOf crosses =
      unlines
        ( if not crosses
            then []
            else
              [ "A crossing is a point where the path crosses the disk's plane; its azimuth is",
                "atan2(z, x). g is the frequency that the observer measures over the frequency",
                "that gas emits there, on its circular orbit or, inside the innermost stable one,",
                "falling inwards."
              ]
        )

reportMembers :: PathReport -> [(String, Json)]
reportMembers report =
  [ ("fate", Text (fateName (reportFate report))),
    ("impactParameter", maybeNumber (reportImpactParameter report)),
    ("sweptAngle", maybeNumber (reportSweptAngle report)),
    ("deflection", maybeNumber (reportDeflection report)),
    ("closestApproach", maybeNumber (reportClosestApproach report)),
    ("crossings", crossingList (reportCrossings report)),
    ("steps", Whole (reportSteps report)),
    ("angularMomentumDrift", maybeNumber (reportAngularMomentumDrift report)),
    ("energyDrift", maybeNumber (reportEnergyDrift report))
  ]

rotatingMembers :: KerrReport -> [(String, Json)]
rotatingMembers report =
  [ ("fate", Text (fateName (kerrReportFate report))),
    ("lambda", Number (kerrReportLambda report)),
    ("carterQ", Number (kerrReportCarter report)),
    ("minoTime", Number (kerrReportMinoTime report)),
    ("frequency", Number (kerrReportObserved report)),
    ("escapeDirection", direction),
    ("crossings", crossingList (kerrReportCrossings report))
  ]
  where
    direction = case kerrReportFate report of
      Escaped (XYZ x y z) -> List [Number x, Number y, Number z]
      _ -> Null

-- | Around a rotating hole: the angle in radians between the directions of escape, and
-- the differences of what else the table changes.
rotatingDifference :: KerrReport -> KerrReport -> [(String, Json)]
rotatingDifference report exact =
  [ ("minoTime", Number (kerrReportMinoTime report - kerrReportMinoTime exact)),
    ( "escapeDirection",
      case (kerrReportFate report, kerrReportFate exact) of
        (Escaped to, Escaped there) -> Number (2 * asin (min 1 (0.5 * XYZ.distance to there)))
        _ -> Null
    ),
    ( "crossings",
      crossingList
        (zipWith crossingDifference (kerrReportCrossings report) (kerrReportCrossings exact))
    )
  ]

differenceMembers :: PathDifference -> [(String, Json)]
differenceMembers difference =
  [ ("impactParameter", maybeNumber (differenceImpactParameter difference)),
    ("sweptAngle", maybeNumber (differenceSweptAngle difference)),
    ("deflection", maybeNumber (differenceDeflection difference)),
    ("closestApproach", maybeNumber (differenceClosestApproach difference)),
    ("crossings", crossingList (differenceCrossings difference)),
    ("angularMomentumDrift", maybeNumber (differenceAngularMomentumDrift difference)),
    ("energyDrift", maybeNumber (differenceEnergyDrift difference))
  ]

crossingList :: [PlaneCrossing Double] -> Json
crossingList crossings =
  List
    [ Object [("r", Number r), ("azimuth", Number azimuth), ("g", Number g)]
      | PlaneCrossing r azimuth g <- crossings
    ]

maybeNumber :: Maybe Double -> Json
maybeNumber = maybe Null Number

-- | The name and content of every single value.
flatten :: [(String, Json)] -> [(String, String)]
flatten = concatMap (uncurry rows)
  where
    rows name json = case json of
      List items ->
        concat
          (zipWith (\n item -> rows (spaced name ++ " " ++ show n) item) [1 :: Int ..] items)
      Object members ->
        concatMap
          (\(key, member) -> rows (singular name ++ ", " ++ key) member)
          members
      Text s -> [(spaced name, s)]
      Number d -> [(spaced name, showDouble d)]
      Whole n -> [(spaced name, show n)]
      Truth b -> [(spaced name, if b then "yes" else "no")]
      Null -> [(spaced name, "-")]
    -- JSON's "impactParameter" is "impact parameter" in the table.
    spaced = concatMap (\c -> if isUpper c then [' ', toLower c] else [c])
    singular name = fromMaybe name (stripPrefix "crossings" name >>= Just . ("crossing" ++))

-- | The unit of the value of this name in the table.
unitOf :: String -> String
unitOf name
  | any (`isSuffixOf` name) ["impact parameter", "closest approach", "lambda", ", r"] = "r_s"
  | "carter q" `isSuffixOf` name = "r_s^2"
  | "mino time" `isSuffixOf` name = "1/r_s"
  | any (`isSuffixOf` name) ["angle", "deflection", "azimuth"] = "rad"
  | otherwise = ""

-- | The points of the path.
outcomePoints :: PhotonOutcome -> [PathPoint]
outcomePoints outcome = case outcome of
  ExactOutcome report -> reportPath report
  ComparedOutcome _ report _ -> reportPath report
  RotatingOutcome report -> timed report
  ComparedRotating report _ -> timed report
  where
    timed report = [PathPoint time place | KerrPathPoint time place <- kerrReportPath report]

-- | The points of the path as CSV: swept angle in radians (around a rotating hole, Mino
-- time), and radius and position in Schwarzschild radii.
outcomeCsv :: PhotonOutcome -> Lazy.ByteString
outcomeCsv outcome =
  Builder.toLazyByteString
    (foldMap line (heading : map row (outcomePoints outcome)))
  where
    heading = [parameter, "r", "x", "y", "z"]
    parameter = case outcome of
      RotatingOutcome _ -> "mino_time"
      ComparedRotating _ _ -> "mino_time"
      _ -> "swept_angle_rad"
    row (PathPoint angle place@(XYZ x y z)) = map showDouble [angle, XYZ.norm place, x, y, z]
    line cells = Builder.string7 (intercalate "," cells) <> Builder.char7 '\n'
